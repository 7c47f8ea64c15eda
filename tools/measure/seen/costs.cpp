#include "tools/measure/seen/costs.h"

#include "play/governor.h"
#include "show/show.h"
#include "tools/common/arguments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace odraz {

namespace {

constexpr char kHead[] = "seconds,kind,quality,width,height,serial,parallel";
constexpr int kPlayLevel = (int)Governor::kPlay;

// The level of a quality by its name; -1 if the player does not use it.
int levelOf(const std::string &name) {
    for (int i = 0; i <= Governor::kSteps; ++i)
        if (name == kQualities[(int)Governor::kRange[i]].name) return i;
    return -1;
}

const Shot *shotAt(double seconds) { return odraz::momentAt(kFilm, seconds * kRowsPerSecond).shot; }

double mix(double a, double b, double t) { return a + (b - a) * t; }
double mixLogarithms(double a, double b, double t) { return std::exp(mix(std::log(a), std::log(b), t)); }
template <class Mix> Cost mixed(const Cost &a, const Cost &b, double t, Mix mix) {
    return {mix(a.serial, b.serial, t), mix(a.parallel, b.parallel, t)};
}

// Multiplies the cost at one size by this to have it at another: a power of the number of pixels.
Cost growth(const std::map<double, Cost> &sizes, double from, double to) {
    auto [fewer, a] = *sizes.begin();
    auto [more, b] = *sizes.rbegin();
    double t = std::log(to / from) / std::log(more / fewer);
    return {std::pow(b.serial / a.serial, t), std::pow(b.parallel / a.parallel, t)};
}

} // namespace

const char kCostsFile[] = ODRAZ_COSTS;

Costs::Costs(const std::string &csv) {
    std::istringstream lines(csv);
    std::string line;
    int number = 0;
    auto wrong = [&](const std::string &what) {
        return Refused("line " + std::to_string(number) + ": " + what);
    };
    while (std::getline(lines, line)) {
        ++number;
        if (number == 1 && line != kHead) throw wrong("it must be \"" + std::string(kHead) + "\"");
        if (number == 1 || line.empty()) continue;
        double seconds, serial, parallel;
        char kind[16], quality[16], behind;
        int width, height;
        if (std::sscanf(line.c_str(), "%lf,%15[a-z],%15[a-z],%d,%d,%lf,%lf%c", &seconds, kind, quality,
                        &width, &height, &serial, &parallel, &behind) != 7)
            throw wrong("it needs the seven values \"" + std::string(kHead) + "\"");
        bool between = std::string(kind) == "between";
        int level = levelOf(quality);
        if (!between && std::string(kind) != "picture") throw wrong("a kind is picture or between");
        if (level < 0) throw wrong("the player does not use the quality '" + std::string(quality) + "'");
        if (!(seconds >= 0 && seconds < duration())) throw wrong("no moment of the film");
        if (width < 16 || height < 16) throw wrong("no size of a picture");
        if (!(serial > 0 && parallel > 0 && std::isfinite(serial + parallel))) throw wrong("no count");
        if (!moments.empty() && seconds < moments.back().seconds)
            throw wrong("it is earlier than the one before");
        if (moments.empty() || seconds > moments.back().seconds)
            moments.push_back({seconds, shotAt(seconds), {}});
        moments.back().kinds[between][level][(double)width * height] = {serial * 1e3, parallel * 1e3};
    }
    for (const Moment &m : moments)
        for (const auto &kind : m.kinds) {
            auto play = kind.find(kPlayLevel);
            if (play == kind.end() || play->second.size() < 2 ||
                (&kind == m.kinds && kind.size() != Governor::kSteps + 1))
                throw Refused("at " + std::to_string(m.seconds) + " s some counts are missing");
        }
}

Cost Costs::at(const Moment &moment, const Pictured &asked) {
    const auto &kind = moment.kinds[asked.between];
    auto ofLevel = [&](int level) {
        const Sizes &sizes = kind.at(level);
        auto [pixels, cost] = *sizes.begin();
        Cost more = growth(sizes.size() > 1 ? sizes : kind.at(kPlayLevel), pixels, asked.pixels);
        return Cost{cost.serial * more.serial, cost.parallel * more.parallel};
    };
    float level = std::clamp(asked.level, (float)kind.begin()->first, (float)kind.rbegin()->first);
    int below = std::min((int)level, kind.rbegin()->first - 1);
    if (!kind.count(below)) return ofLevel(below + 1);
    return mixed(ofLevel(below), ofLevel(below + 1), level - (float)below, mixLogarithms);
}

Cost Costs::of(const Pictured &asked) const {
    const Shot *shot = shotAt(asked.seconds);
    const Moment *before = nullptr, *after = nullptr;
    for (const Moment &m : moments) {
        if (m.shot != shot) continue;
        if (m.seconds <= asked.seconds) before = &m;
        if (m.seconds >= asked.seconds && !after) after = &m;
    }
    if (!before && !after)
        throw Refused("no cost was counted for the shot at " + std::to_string(asked.seconds) + " s");
    if (!before) before = after;
    if (!after) after = before;
    double span = after->seconds - before->seconds;
    return mixed(at(*before, asked), at(*after, asked),
                 span > 0 ? (asked.seconds - before->seconds) / span : 0, mix);
}

} // namespace odraz
