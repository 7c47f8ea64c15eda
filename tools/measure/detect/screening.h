// Gives tools any picture of the film, traced on all processors, and the times of its scenes.
#pragma once

#include "inside.h"
#include "tools/common/command_line.h"
#include "tools/engine/heap_arena.h"
#include "tools/engine/machine.h"

#include <vector>

namespace odraz::measure {

// The film, loaded for pictures of one size.
struct LoadedFilm {
    // Solves the hall if asked to. Throws std::runtime_error.
    LoadedFilm(const IntroSettings &settings, Workers &workers, bool hall);
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
    // The picture as --dump writes it.
    Picture picture(double seconds, const Quality &quality) {
        return odraz::picture(*film.intro, 0, seconds, quality);
    }

private:
    Workers workers;
    LoadedFilm film;
};

// The quality of a level, as the governor blends it: 0 film, 1 play, 2 draft.
Quality qualityOf(float level);

// A part of the film, in seconds; of one scene.
struct Span {
    int scene;
    double from, to;
};
// Its shots, in order: all, or those of the scene of this name. Throws Refused if there is no such scene, or
// if it is not played.
std::vector<Span> shots();
std::vector<Span> shotsOf(const std::string &scene);
// `count` windows of a length, evenly spaced; clipped to the span.
std::vector<Span> windowsIn(const Span &span, int count, double length);

// The options common to all programs that look at the film: --size, --quality.
struct ScreeningOptions {
    IntroSettings size = {1280, 720};
    QualityName quality = QualityName::Play;
    void addTo(common::CommandLine &line);
    const Quality &chosen() const { return kQualities[(int)quality]; }
};

// An option whose value is a size, such as 1280x720.
void sizeOption(common::CommandLine &line, const std::string &name, IntroSettings &to,
                const std::string &what);
// Parses a size; throws Refused for anything else.
IntroSettings sizeFrom(const std::string &option, const std::string &text);

} // namespace odraz::measure
