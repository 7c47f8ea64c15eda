#include "tools/measure/play/costs.h"

#include "play/governor.h"
#include "show/show.h"
#include "tools/common/command_line.h"
#include "tools/measure/play/shown.h"

#include <cmath>
#include <cstdio>

namespace odraz::measure {

namespace {

constexpr char kHead[] = "seconds,gap,level,width,height,serial,parallel";

const Shot *shotAt(double seconds) { return momentAt(kFilm, seconds * kRowsPerSecond).shot; }

double mix(double a, double b, double t) { return a + (b - a) * t; }
double mixLogarithms(double a, double b, double t) { return std::exp(mix(std::log(a), std::log(b), t)); }
template <class Mix> PictureCost mixed(const PictureCost &a, const PictureCost &b, double t, Mix mix) {
    return {mix(a.serial, b.serial, t), mix(a.parallel, b.parallel, t)};
}

// The factor by which the cost grows from one number of pixels to another: a power of their ratio.
PictureCost growth(const std::map<double, PictureCost> &sizes, double from, double to) {
    auto [fewer, a] = *sizes.begin();
    auto [more, b] = *sizes.rbegin();
    double t = std::log(to / from) / std::log(more / fewer);
    return {std::pow(b.serial / a.serial, t), std::pow(b.parallel / a.parallel, t)};
}

} // namespace

const char kCostsFile[] = ODRAZ_COSTS;

PictureCosts::PictureCosts(const std::string &csv) {
    forRows(csv, kHead, [&](const std::string &line) {
        double seconds, gap, level, serial, parallel;
        char extra;
        int width, height;
        common::need(std::sscanf(line.c_str(), "%lf,%lf,%lf,%d,%d,%lf,%lf%c", &seconds, &gap, &level, &width,
                                 &height, &serial, &parallel, &extra) == 7,
                     "a row needs the seven values \"" + std::string(kHead) + "\"");
        common::need(gap == 0 || (gap >= 1 && gap <= 60), "the gap must be 0, or 1 to 60 sixtieths");
        common::need(level >= 0 && level <= Governor::kSteps, "the level must be 0 to 2");
        common::need(seconds >= 0 && seconds < duration(), "the time is outside the film");
        common::need(width >= 16 && height >= 16, "a picture has at least 16 x 16 pixels");
        common::need(serial > 0 && parallel > 0 && std::isfinite(serial + parallel),
                     "counts must be positive");
        common::need(moments.empty() || seconds >= moments.back().seconds, "rows must be in order of time");
        if (moments.empty() || seconds > moments.back().seconds)
            moments.push_back({seconds, shotAt(seconds), {}});
        moments.back().gaps[gap][(float)level][(double)width * height] = {serial * 1e3, parallel * 1e3};
    });
    for (const CountedMoment &m : moments) {
        std::string at = "at " + std::to_string(m.seconds) + " s ";
        if (!m.gaps.count(0) || m.gaps.size() < 2)
            throw common::Refused(at + "no traced picture or no in-between was counted");
        for (const auto &[gap, levels] : m.gaps) {
            auto play = levels.find(Governor::kPlay);
            if (play == levels.end() || play->second.size() < 2)
                throw common::Refused(at + "level 1 was not counted in two sizes");
        }
    }
}

PictureCost PictureCosts::at(const Levels &levels, const PictureKind &asked) {
    auto counted = [&](const Sizes &sizes) {
        auto [pixels, cost] = *sizes.begin();
        PictureCost more =
            growth(sizes.size() > 1 ? sizes : levels.at(Governor::kPlay), pixels, asked.pixels);
        return PictureCost{cost.serial * more.serial, cost.parallel * more.parallel};
    };
    auto after = levels.lower_bound(asked.level);
    if (after == levels.end()) return counted(levels.rbegin()->second);
    if (after == levels.begin()) return counted(after->second);
    auto before = std::prev(after);
    return mixed(counted(before->second), counted(after->second),
                 (asked.level - before->first) / (after->first - before->first), mixLogarithms);
}

PictureCost PictureCosts::at(const CountedMoment &moment, const PictureKind &asked) {
    const auto &gaps = moment.gaps;
    if (!asked.gap) return at(gaps.at(0), asked);
    auto after = gaps.lower_bound(asked.gap);
    if (after == gaps.end()) return at(gaps.rbegin()->second, asked);
    auto before = std::prev(after);
    if (!before->first) return at(after->second, asked); // no in-between is counted at a smaller gap
    return mixed(at(before->second, asked), at(after->second, asked),
                 (asked.gap - before->first) / (after->first - before->first), mix);
}

PictureCost PictureCosts::of(const PictureKind &asked) const {
    const Shot *shot = shotAt(asked.seconds);
    const CountedMoment *before = nullptr, *after = nullptr;
    for (const CountedMoment &m : moments) {
        if (m.shot != shot) continue;
        if (m.seconds <= asked.seconds) before = &m;
        if (m.seconds >= asked.seconds && !after) after = &m;
    }
    if (!before && !after)
        throw common::Refused("no cost was counted for the shot at " + std::to_string(asked.seconds) + " s");
    if (!before) before = after;
    if (!after) after = before;
    double span = after->seconds - before->seconds;
    return mixed(at(*before, asked), at(*after, asked),
                 span > 0 ? (asked.seconds - before->seconds) / span : 0, mix);
}

} // namespace odraz::measure
