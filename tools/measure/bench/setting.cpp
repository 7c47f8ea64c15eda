#include "tools/measure/bench/setting.h"

#include "play/governor.h"
#include "tools/common/command_line.h"
#include "tools/measure/bench/screening.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace odraz::measure {

namespace {

// Parses a number or a quotient of two numbers
float number(const std::string &knob, const std::string &text) {
    char *end = nullptr;
    float value = std::strtof(text.c_str(), &end);
    if (*end == '/') value /= std::strtof(end + 1, &end);
    if (text.empty() || *end) throw common::Refused(knob + " needs a number, not '" + text + "'");
    return value;
}

struct Knob {
    const char *name;
    int *whole; // either this or `real` is null
    float *real;
    std::vector<float> values; // the allowed values of `whole`; `real` may have any that is not negative
};

std::vector<float> upTo(int most) {
    std::vector<float> all;
    for (int k = 0; k <= most; ++k) all.push_back((float)k);
    return all;
}

std::vector<Knob> knobsOf(Quality &q) {
    return {
        {"grid", &q.grid, nullptr, upTo(16)},
        {"coarse", &q.coarse, nullptr, {4, 8, 16, 32}},
        {"smallest", &q.smallest, nullptr, {4, 8}},
        {"depth", &q.depth, nullptr, upTo(kMaxDepth)},
        {"threshold", nullptr, &q.threshold, {}},
        {"markThreshold", nullptr, &q.markThreshold, {}},
        {"edge", nullptr, &q.edge, {}},
        {"outline", nullptr, &q.outline, {}},
        {"again", nullptr, &q.again, {}},
        {"textureEdge", nullptr, &q.textureEdge, {}},
        {"markWeight", nullptr, &q.markWeight, {}},
        {"cutoff", nullptr, &q.cutoff, {}},
    };
}

void turn(Quality &q, const std::string &knob, float value) {
    const std::vector<Knob> knobs = knobsOf(q);
    const Knob &k = common::named(knobs, knob, "knob", [](const Knob &k) { return k.name; });
    if (k.whole ? std::find(k.values.begin(), k.values.end(), value) == k.values.end()
                : !(value >= 0 && std::isfinite(value)))
        throw common::Refused(knob + " cannot have this value: see intro/trace/quality.h");
    if (k.whole)
        *k.whole = (int)value;
    else
        *k.real = value;
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
        turn(setting, knob, number(knob, change.substr(equals + 1)));
        comma = next;
    }
    if (!setting.grid && !(setting.smallest && setting.coarse))
        throw common::Refused("a setting without a grid needs coarse and smallest");
    return setting;
}

} // namespace odraz::measure
