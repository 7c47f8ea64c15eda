#include "tools/measure/setting.h"

#include "tools/common/arguments.h"

#include <cstdlib>

namespace odraz {

namespace {

// A number or a quotient of two
float number(const std::string &knob, const std::string &text) {
    char *end = nullptr;
    float value = std::strtof(text.c_str(), &end);
    if (*end == '/') value /= std::strtof(end + 1, &end);
    if (text.empty() || *end) throw Refused("'" + text + "' is no value of " + knob);
    return value;
}

void turn(Quality &q, const std::string &knob, float value) {
    struct {
        const char *name;
        int *whole;
        float *real;
    } const knobs[] = {
        {"grid", &q.grid, nullptr},     {"coarse", &q.coarse, nullptr}, {"fine", &q.fine, nullptr},
        {"texels", &q.texels, nullptr}, {"depth", &q.depth, nullptr},   {"threshold", nullptr, &q.threshold},
        {"mild", nullptr, &q.mild},     {"edge", nullptr, &q.edge},     {"mark", nullptr, &q.mark},
        {"cutoff", nullptr, &q.cutoff},
    };
    std::string known;
    for (auto &k : knobs) {
        if (knob == k.name) {
            if (k.whole)
                *k.whole = (int)value;
            else
                *k.real = value;
            return;
        }
        known += std::string(" ") + k.name;
    }
    throw Refused("there is no knob '" + knob + "'; there are:" + known);
}

} // namespace

Quality settingOf(const std::string &words) {
    size_t comma = words.find_first_of(", ");
    std::string name = words.substr(0, comma), known;
    const Quality *named = nullptr;
    for (const Quality &q : kQualities) {
        if (name == q.name) named = &q;
        known += std::string(" ") + q.name;
    }
    if (!named) throw Refused("there is no quality '" + name + "'; there are:" + known);
    Quality setting = *named;
    while (comma != std::string::npos) {
        size_t next = words.find_first_of(", ", comma + 1);
        std::string turned = words.substr(comma + 1, next - comma - 1);
        size_t is = turned.find('=');
        if (is == std::string::npos) throw Refused("'" + turned + "' is not KNOB=VALUE");
        std::string knob = turned.substr(0, is);
        turn(setting, knob, number(knob, turned.substr(is + 1)));
        comma = next;
    }
    return setting;
}

} // namespace odraz
