// Gives tools any picture of the film, traced on all processors, and the times of its scenes.
#pragma once

#include "inside.h"
#include "tools/common/arguments.h"
#include "tools/engine/heap_arena.h"
#include "tools/engine/machine.h"

#include <vector>

namespace odraz {

// The film, loaded for pictures of one size.
struct Theatre {
    // Solves the hall if it is shown between two moments, in seconds. Throws std::runtime_error.
    Theatre(const IntroSettings &settings, Workers &workers, double from, double to);
    HeapArena memory;
    Intro *intro = nullptr; // in the arena
};

// A picture without its fourth bytes.
std::vector<uint8_t> rgbOf(const Picture &picture);

class Screening {
public:
    // Prepares the film from one second to another; solves the hall if it is shown there. Throws
    // std::runtime_error.
    Screening(IntroSettings settings, double from, double to);
    // The picture as a dump has it.
    Picture picture(double seconds, const Quality &quality) {
        return odraz::picture(*theatre.intro, 0, seconds, quality);
    }
    // The picture as it is shown, in levels of 255, neither dithered nor rounded. In each row all red values
    // come first, then green, then blue.
    std::vector<float> shown(double seconds, const Quality &quality);

private:
    Workers workers;
    Theatre theatre;
};

// A part of the film, in seconds; of one scene.
struct Span {
    int scene;
    double from, to;
};
// Its shots, in order: all, or those of the scene of this name. Throws Refused if there is no such scene, or
// if it is not played.
std::vector<Span> shots();
std::vector<Span> shotsOf(const std::string &scene);
// `count` windows of a length, evenly spaced; each as much of it as lies within the span.
std::vector<Span> windowsIn(const Span &span, int count, double length);

// The options that all programs that look at the film share: --size, --quality, --keep.
struct ScreeningOptions {
    std::string size = "1280x720";
    std::vector<std::string> qualities; // empty: play
    std::string keep;                   // a folder that keeps pictures; empty: none is kept

    // Takes the value if the option is one of these; else returns false. Throws Refused.
    bool take(const std::string &option, common::Arguments &words);
};

// Parses "1280x720"; throws Refused for anything else.
IntroSettings sizeFrom(const std::string &words);
// The quality of this name; throws Refused if there is none.
const Quality &qualityFrom(const std::string &name);

} // namespace odraz
