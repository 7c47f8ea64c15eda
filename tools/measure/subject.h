// What tracers are measured on: the scenes shared with other tracers, and the film's.
#pragma once

#include "inside.h"
#include "tools/common/heap_arena.h"

#include <string>
#include <vector>

namespace odraz {

struct SubjectName {
    const char *name;
    double seconds; // into the film; < 0: not of the film
    bool hall;
};

// In the order in which they are measured.
const std::vector<SubjectName> &subjectNames();

// Poses it in the film's scene; returns how it is looked at.
View poseSubject(const SubjectName &name, const IntroSettings &settings, const Film &film);

// A scene, posed, with all that tracing it needs. Throws std::runtime_error with a line that tells why not.
class Subject {
public:
    Subject(const SubjectName &name, int width, int height);

    // Traces a picture on one thread; returns the processor time that took, in milliseconds.
    double trace(const Quality &quality);
    double samplesPerPixel() const;
    // The picture as eight-bit sRGB, clamped at 1, without film curve: 3 bytes a pixel.
    std::vector<uint8_t> picture() const;
    // The same of 256 samples in every pixel, box-filtered: traced once, then kept.
    const std::vector<uint8_t> &reference();

    Scene &scene() { return *intro->film.scene; }
    const View &view() const { return theView; }

private:
    IntroSettings settings;
    HeapArena memory;
    Workers workers;
    Intro *intro = nullptr; // in the arena
    View theView = {};
    std::vector<uint8_t> truth;
};

} // namespace odraz
