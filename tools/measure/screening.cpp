#include "tools/measure/screening.h"

#include "tools/common/arguments.h"

#include <cstdio>

namespace odraz {

Screening::Screening(IntroSettings settings, double from, double to)
    : workers(allProcessors()), hall(needsHall(from, to)),
      memory(memoryNeeded(settings, workers.count, hall)) {
    Gl gl = hall ? openGl() : Gl{};
    if (const char *wrong = load(intro, settings, memory.arena, workers, hall ? &gl : nullptr))
        throw std::runtime_error(wrong);
}

IntroSettings sizeFrom(const std::string &words) {
    IntroSettings s = {};
    char behind;
    if (std::sscanf(words.c_str(), "%dx%d%c", &s.width, &s.height, &behind) != 2 || s.width < 16 ||
        s.height < 16 || s.width > 7680 || s.height > 4320)
        throw Refused("a size is like 1280x720, not " + words);
    return s;
}

const Quality &qualityFrom(const std::string &name) {
    for (const Quality &q : kQualities)
        if (name == q.name) return q;
    throw Refused("there is no quality '" + name + "'");
}

} // namespace odraz
