#include "tools/measure/seen/shown.h"

#include "play/governor.h"
#include "tools/common/arguments.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace odraz {

namespace {

constexpr char kHead[] = "at,time,kind,level,width,height";
constexpr int kMostPixels = 7680; // across

} // namespace

Quality qualityOf(float level) {
    Governor governor;
    governor.coarseness = level;
    return governor.quality();
}

std::string printShown(const std::vector<Shown> &list) {
    std::string text = kHead;
    text += "\n";
    char line[160];
    for (const Shown &s : list) {
        std::snprintf(line, sizeof line, "%.6f,%.6f,%s,%.4f,%d,%d\n", s.at, s.time,
                      s.between ? "between" : "traced", (double)s.level, s.width, s.height);
        text += line;
    }
    return text;
}

std::vector<Shown> parseShown(const std::string &csv) {
    std::vector<Shown> list;
    std::istringstream lines(csv);
    std::string line;
    int number = 0;
    double lastAt = 0;
    auto wrong = [&](const std::string &what) {
        return common::Refused("line " + std::to_string(number) + ": " + what);
    };
    while (std::getline(lines, line)) {
        ++number;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (number == 1) {
            if (line != kHead) throw wrong("it must be \"" + std::string(kHead) + "\"");
            continue;
        }
        if (line.empty()) continue;
        Shown s = {};
        char kind[16], behind;
        double level;
        if (std::sscanf(line.c_str(), "%lf,%lf,%15[a-z],%lf,%d,%d%c", &s.at, &s.time, kind, &level, &s.width,
                        &s.height, &behind) != 6)
            throw wrong("it needs the six values \"" + std::string(kHead) + "\"");
        s.between = std::string(kind) == "between";
        s.level = (float)level;
        if (!s.between && std::string(kind) != "traced")
            throw wrong("a picture is traced or between, not '" + std::string(kind) + "'");
        if (!std::isfinite(s.at) || !std::isfinite(s.time) || s.time < 0)
            throw wrong("no moment of the film");
        if (!(level >= 0 && level <= Governor::kSteps)) throw wrong("levels are 0 to 2");
        if (s.width < 16 || s.height < 16 || s.width > kMostPixels || s.height > kMostPixels)
            throw wrong("no size of a picture");
        if (!list.empty() && s.time < list.back().time) throw wrong("it is earlier than the one before");
        if (s.at >= 0 && s.at < lastAt) throw wrong("it came on the screen earlier than the one before");
        lastAt = std::max(s.at, lastAt);
        if (s.between && list.empty()) throw wrong("an in-between needs a traced picture before it");
        if (!list.empty() && list.back().between &&
            (list.back().width != s.width || list.back().height != s.height))
            throw wrong("the in-between before it must have its size");
        list.push_back(s);
    }
    if (!number) throw common::Refused("it is empty");
    if (!list.empty() && list.back().between) throw wrong("an in-between needs a traced picture after it");
    return list;
}

double MadeFrom::gap() const { return (later.time - earlier.time) * 60; }

MadeFrom madeFrom(const std::vector<Shown> &list, size_t i) {
    size_t before = i, after = i;
    while (list[before].between) --before;
    while (list[after].between) ++after;
    return {list[before], list[after]};
}

int standsAt(const std::vector<Shown> &list, double seconds) {
    int found = -1;
    for (size_t i = 0; i < list.size(); ++i)
        if (list[i].at >= 0 && list[i].at <= seconds) found = (int)i;
    return found;
}

std::vector<Shown> steady(double from, double to, double rate, int every, float level, int width,
                          int height) {
    std::vector<Shown> list;
    // Counted from the film's start, so that the same pictures are made wherever it begins
    long first = std::max(0l, (long)std::floor(from * rate)), last = (long)std::ceil(to * rate);
    first -= first % every, last += (every - last % every) % every;
    for (long n = first; n <= last; ++n)
        list.push_back({(double)n / rate, (double)n / rate, n % every != 0, level, width, height});
    return list;
}

} // namespace odraz
