// The film, loaded for measurements: its pictures, qualities, and the times of its scenes.
#pragma once

#include "inside.h"
#include "tools/common/command_line.h"
#include "tools/support/heap_arena.h"
#include "tools/support/machine.h"

#include <vector>

namespace odraz::measure {

// The film, loaded for pictures of one size.
struct MeasuredFilm {
    // Solves the hall if `hall`. Throws std::runtime_error.
    MeasuredFilm(IntroSettings settings, Workers &workers, bool hall);
    HeapArena memory;
    Intro *intro = nullptr; // in the arena
};

// The red, green and blue bytes of a picture, 3 a pixel.
std::vector<uint8_t> rgbOf(const Picture &picture);

// The quality of a level, as the governor blends it: 0 film, 1 play, 2 draft.
Quality qualityOf(float level);

// A time span of the film, in seconds, within one scene.
struct Span {
    int scene;
    double from, to;
};
// All shots of the film, in order.
std::vector<Span> shots();
// The shots of one scene. Throws Refused if there is no scene of this name, or if the film does not play it.
std::vector<Span> shotsOf(const std::string &scene);
// `count` windows of `length` seconds, evenly spaced in the span and clipped to it.
std::vector<Span> windowsIn(const Span &span, int count, double length);

// Adds an option whose value is a size, such as 1280x720.
void sizeOption(common::CommandLine &line, const std::string &name, IntroSettings &to,
                const std::string &what);
// Parses a size. Throws Refused for anything else.
IntroSettings sizeFrom(const std::string &option, const std::string &text);

} // namespace odraz::measure
