// The scenes that tracers are measured on: those shared with other tracers, and those of the film.
#pragma once

#include "inside.h"
#include "tools/measure/detect/screening.h"

#include <functional>
#include <string>
#include <vector>

namespace odraz::measure {

struct SubjectName {
    std::string name;
    bool hall;
    std::function<void(Scene &)> pose = {}; // empty: the film poses it
    const CameraKey *camera = nullptr;      // null: the film's
    double seconds = 0;                     // into the film, for its scenes
};

// All subjects, in the order in which they are measured.
const std::vector<SubjectName> &subjectNames();

// Throws Refused if there is none of this name.
SubjectName findSubject(const std::string &name);

// Poses the subject in the film's scene; returns its view.
View poseSubject(const SubjectName &subject, const IntroSettings &settings, const Film &film);

// A posed scene with all that tracing it needs. Throws std::runtime_error with a line that gives the reason.
class Subject {
public:
    Subject(const SubjectName &name, int width, int height);

    // On one thread. Returns its processor time in milliseconds.
    double trace(const Quality &quality);
    double samplesPerPixel() const;
    // The picture as eight-bit sRGB, clamped at 1, without the film curve: 3 bytes a pixel.
    std::vector<uint8_t> picture() const;
    // The same with 256 samples in every pixel, box-filtered.
    std::vector<uint8_t> reference();

    int width() const { return settings.width; }
    int height() const { return settings.height; }

private:
    IntroSettings settings;
    Workers workers;
    LoadedFilm film;
    View view;
};

} // namespace odraz::measure
