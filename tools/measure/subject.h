// What tracers are measured on: the scenes shared with other tracers, and the film's.
#pragma once

#include "inside.h"
#include "tools/common/heap_arena.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace odraz {

// How a subject is looked at: as the film does at a time, or by a camera of its own.
struct SubjectCamera {
    double seconds;                    // into the film, for its scenes
    const CameraKey *camera = nullptr; // null: the film's
};

struct SubjectName {
    std::string name;
    bool hall;
    std::function<void(Scene &)> pose; // empty: the film does
    std::vector<SubjectCamera> cameras;
};

// In the order in which they are measured.
const std::vector<SubjectName> &subjectNames();

// One of them, or what grows: "balls:N", N balls on a floor; "lights:N", A with N lights. Throws Refused.
SubjectName findSubject(const std::string &name);

// "A" or "A/2": a subject and which of its cameras, from 0 on. Throws Refused.
std::pair<SubjectName, size_t> findPicture(const std::string &name);

// Poses it in the film's scene; returns how it is looked at.
View poseSubject(const SubjectName &name, size_t camera, const IntroSettings &settings, const Film &film);

// A scene, posed, with all that tracing it needs. Throws std::runtime_error with a line that tells why not.
class Subject {
public:
    Subject(const SubjectName &name, int width, int height, int threads = 1);

    // These return the processor time that they took, in milliseconds of one thread. At first all is as
    // camera 0 has it.
    double pose(size_t camera);
    double trace(const Quality &quality);
    double develop(); // as it is shown

    double samplesPerPixel() const;
    // The picture as eight-bit sRGB, clamped at 1, without film curve: 3 bytes a pixel.
    std::vector<uint8_t> picture() const;
    // The same of 256 samples in every pixel, box-filtered.
    std::vector<uint8_t> reference();

    int width() const { return settings.width; }
    int height() const { return settings.height; }
    Scene &scene() { return *intro->film.scene; }
    const View &view() const { return theView; }

private:
    IntroSettings settings;
    HeapArena memory;
    Workers workers;
    Intro *intro = nullptr; // in the arena
    SubjectName name;
    View theView = {};
};

} // namespace odraz
