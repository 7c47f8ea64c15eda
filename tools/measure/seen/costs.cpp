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

constexpr char kHead[] = "seconds,kind,level,width,height,serial,parallel";

const Shot *shotAt(double seconds) { return momentAt(kFilm, seconds * kRowsPerSecond).shot; }

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
        double seconds, level, serial, parallel;
        char kind[16], behind;
        int width, height;
        if (std::sscanf(line.c_str(), "%lf,%15[a-z],%lf,%d,%d,%lf,%lf%c", &seconds, kind, &level, &width,
                        &height, &serial, &parallel, &behind) != 7)
            throw wrong("it needs the seven values \"" + std::string(kHead) + "\"");
        bool between = std::string(kind) == "between";
        if (!between && std::string(kind) != "picture") throw wrong("a kind is picture or between");
        if (!(level >= 0 && level <= Governor::kSteps)) throw wrong("levels are 0 to 2");
        if (!(seconds >= 0 && seconds < duration())) throw wrong("no moment of the film");
        if (width < 16 || height < 16) throw wrong("no size of a picture");
        if (!(serial > 0 && parallel > 0 && std::isfinite(serial + parallel))) throw wrong("no count");
        if (!moments.empty() && seconds < moments.back().seconds)
            throw wrong("it is earlier than the one before");
        if (moments.empty() || seconds > moments.back().seconds)
            moments.push_back({seconds, shotAt(seconds), {}});
        moments.back().kinds[between][(float)level][(double)width * height] = {serial * 1e3, parallel * 1e3};
    }
    for (const Moment &m : moments)
        for (const Levels &levels : m.kinds) {
            auto play = levels.find(Governor::kPlay);
            if (play == levels.end() || play->second.size() < 2)
                throw Refused("at " + std::to_string(m.seconds) + " s level 1 is not counted in two sizes");
        }
}

Cost Costs::at(const Moment &moment, const Pictured &asked) {
    const Levels &levels = moment.kinds[asked.between];
    auto counted = [&](const Sizes &sizes) {
        auto [pixels, cost] = *sizes.begin();
        Cost more = growth(sizes.size() > 1 ? sizes : levels.at(Governor::kPlay), pixels, asked.pixels);
        return Cost{cost.serial * more.serial, cost.parallel * more.parallel};
    };
    auto after = levels.lower_bound(asked.level);
    if (after == levels.end()) return counted(levels.rbegin()->second);
    if (after == levels.begin()) return counted(after->second);
    auto before = std::prev(after);
    return mixed(counted(before->second), counted(after->second),
                 (asked.level - before->first) / (after->first - before->first), mixLogarithms);
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
