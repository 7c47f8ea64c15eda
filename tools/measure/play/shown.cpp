#include "tools/measure/play/shown.h"

#include "play/governor.h"
#include "tools/common/command_line.h"
#include "tools/common/text.h"
#include "trace/picture/frame.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace odraz::measure {

static constexpr char kHead[] = "at,time,kind,level,width,height,seconds";

void forRows(const std::string &csv, const std::string &head,
             const std::function<void(const std::string &line)> &row) {
    std::istringstream lines(csv);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        try {
            if (number == 1 && line != head) throw common::Refused("must be \"" + head + "\"");
            if (number > 1 && !line.empty()) row(line);
        } catch (const common::Refused &why) {
            throw common::Refused("line " + std::to_string(number) + ": " + why.what());
        }
    }
    if (csv.empty()) throw common::Refused("the file is empty");
}

std::string printShown(const std::vector<ShownPicture> &list) {
    std::string text = common::format("%s\n", kHead);
    for (const ShownPicture &s : list)
        common::append(text, "%.6f,%.6f,%s,%.4f,%d,%d,%.6f\n", s.at, s.time, s.between ? "between" : "traced",
                       (double)s.level, s.width, s.height, s.seconds);
    return text;
}

std::vector<ShownPicture> parseShown(const std::string &csv) {
    std::vector<ShownPicture> list;
    double lastAt = 0;
    forRows(csv, kHead, [&](const std::string &line) {
        ShownPicture s = {};
        char kind[16], extra;
        double level;
        common::need(std::sscanf(line.c_str(), "%lf,%lf,%15[a-z],%lf,%d,%d,%lf%c", &s.at, &s.time, kind,
                                 &level, &s.width, &s.height, &s.seconds, &extra) == 7,
                     "a row needs the seven values \"" + std::string(kHead) + "\"");
        s.between = std::string(kind) == "between";
        s.level = (float)level;
        common::need(s.between || std::string(kind) == "traced",
                     "the kind must be traced or between, not '" + std::string(kind) + "'");
        common::need(std::isfinite(s.at) && std::isfinite(s.time) && s.time >= 0,
                     "the time is outside the film");
        common::need(level >= 0 && level <= Governor::kSteps, "the level must be 0 to 2");
        common::need(s.width >= 16 && s.height >= 16 && s.width <= kMaxWidth && s.height <= kMaxHeight,
                     "a picture cannot have this size");
        common::need(s.seconds >= 0 && std::isfinite(s.seconds), "the seconds must be 0 or more");
        common::need(s.at < 0 || s.at >= lastAt, "it was shown before the previous row");
        lastAt = std::max(s.at, lastAt);
        common::need(!s.between || !list.empty(), "an in-between needs a traced picture before it");
        if (!list.empty()) {
            const ShownPicture &before = list.back();
            common::need(s.time >= before.time, "rows must be in order of time");
            common::need(!before.between || (before.width == s.width && before.height == s.height),
                         "the in-between before it must have the same size");
        }
        list.push_back(s);
    });
    if (!list.empty() && list.back().between)
        throw common::Refused("the last line: an in-between needs a traced picture after it");
    return list;
}

double MadeFrom::gap() const { return (later.time - earlier.time) * 60; }

MadeFrom madeFrom(const std::vector<ShownPicture> &list, size_t i) {
    size_t before = i, after = i;
    while (list[before].between) --before;
    while (list[after].between) ++after;
    return {list[before], list[after]};
}

int onScreenAt(const std::vector<ShownPicture> &list, double seconds) {
    int found = -1;
    for (size_t i = 0; i < list.size(); ++i)
        if (list[i].at >= 0 && list[i].at <= seconds) found = (int)i;
    return found;
}

} // namespace odraz::measure
