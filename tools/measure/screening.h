// The film as tools look at it: any picture of it, on all processors.
#pragma once

#include "inside.h"
#include "tools/common/heap_arena.h"
#include "tools/common/machine.h"

#include <vector>

namespace odraz {

class Screening {
public:
    // Of the film from one second to another; solves the hall if some of that plays there. Throws
    // std::runtime_error.
    Screening(IntroSettings settings, double from, double to);
    // As a dump has it.
    Picture picture(double seconds, const Quality &quality) {
        return odraz::picture(*intro, seconds, quality);
    }
    // The same as it is shown, in levels of 255, neither dithered nor rounded: all red ones of a
    // row, then green, then blue.
    std::vector<float> shown(double seconds, const Quality &quality);

private:
    Workers workers;
    bool hall;
    HeapArena memory;
    Intro *intro = nullptr; // in the arena
};

// "1280x720"; throws Refused for anything else.
IntroSettings sizeFrom(const std::string &words);
// A quality by its name; throws Refused where there is none.
const Quality &qualityFrom(const std::string &name);

} // namespace odraz
