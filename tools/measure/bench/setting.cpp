#include "tools/measure/bench/setting.h"

#include "play/governor.h"
#include "tools/common/command_line.h"
#include "tools/measure/bench/screening.h"

#include <bit>
#include <vector>

namespace odraz::measure {

namespace {

struct Knob {
    const char *name;
    int *whole; // either this or `real` is null
    float *real;
    common::Range range;
};

std::vector<Knob> knobsOf(Quality &q) {
    constexpr common::Range kAny = {0, 1e6};
    return {
        {"grid", &q.grid, nullptr, {0, 16}},
        {"coarse", &q.coarse, nullptr, {4, 32}},
        {"smallest", &q.smallest, nullptr, {4, 8}},
        {"depth", &q.depth, nullptr, {0, kMaxDepth}},
        {"threshold", nullptr, &q.threshold, kAny},
        {"markThreshold", nullptr, &q.markThreshold, kAny},
        {"edge", nullptr, &q.edge, kAny},
        {"outline", nullptr, &q.outline, kAny},
        {"again", nullptr, &q.again, kAny},
        {"textureEdge", nullptr, &q.textureEdge, kAny},
        {"markWeight", nullptr, &q.markWeight, kAny},
        {"cutoff", nullptr, &q.cutoff, kAny},
    };
}

void turn(Quality &q, const std::string &knob, const std::string &text) {
    const std::vector<Knob> knobs = knobsOf(q);
    const Knob &k = common::named(knobs, knob, "knob", [](const Knob &k) { return k.name; });
    double value = common::numberOf(knob, text, k.range);
    if (k.real)
        *k.real = (float)value;
    else
        *k.whole = (int)value;
    if (k.whole && *k.whole != value) throw common::Refused(knob + " needs a whole number");
}

// A quality by its name, or the governor's quality at a level
Quality named(const std::string &name) {
    if (name.rfind("level=", 0) == 0) {
        double level = common::numberOf("level", name.substr(6), {0, Governor::kSteps});
        return qualityOf((float)level);
    }
    return common::named(kQualities, name, "quality", [](const Quality &q) { return q.name; });
}

} // namespace

Quality settingOf(const std::string &words) {
    size_t comma = words.find_first_of(", ");
    Quality setting = named(words.substr(0, comma));
    while (comma != std::string::npos) {
        size_t next = words.find_first_of(", ", comma + 1);
        std::string change = words.substr(comma + 1, next - comma - 1);
        size_t equals = change.find('=');
        if (equals == std::string::npos)
            throw common::Refused("cannot use '" + change + "': write KNOB=VALUE");
        std::string knob = change.substr(0, equals);
        turn(setting, knob, change.substr(equals + 1));
        comma = next;
    }
    for (int size : {setting.coarse, setting.smallest})
        common::need(!size || std::has_single_bit((unsigned)size),
                     "coarse and smallest must be powers of two");
    common::need(setting.grid || (setting.smallest && setting.coarse),
                 "a setting without a grid needs coarse and smallest");
    return setting;
}

} // namespace odraz::measure
