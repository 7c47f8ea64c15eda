#include "maker/panel/content.h"

#include <algorithm>
#include <cctype>

namespace odraz::maker {

const ShotInfo &Content::shotAt(double time) const {
    auto next = std::upper_bound(shots.begin() + 1, shots.end(), time,
                                 [](double t, const ShotInfo &s) { return t < s.from; });
    return *(next - 1);
}

Content contentOf(const Inspector &inspector) {
    Content c;
    c.shots.resize(1024), c.events.resize(1024);
    c.shots.resize((size_t)inspector.shots(c.shots.data(), 1024));
    c.events.resize((size_t)inspector.events(c.events.data(), 1024));
    std::sort(c.events.begin(), c.events.end(),
              [](const EventInfo &a, const EventInfo &b) { return a.at < b.at; });
    c.end = c.shots.back().to;
    return c;
}

std::string inWords(const EventInfo &event) {
    std::string words;
    for (const char *c = event.name + (*event.name == 'k'); *c; ++c) {
        bool figure = std::isdigit((unsigned char)*c),
             before = !words.empty() && std::isdigit((unsigned char)c[-1]);
        if (!words.empty() && (std::isupper((unsigned char)*c) || (figure && !before))) words += ' ';
        words += (char)std::tolower((unsigned char)*c);
    }
    return words;
}

} // namespace odraz::maker
