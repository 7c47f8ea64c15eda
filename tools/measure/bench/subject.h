// The scenes that tracers are measured on: those shared with other tracers, and those of the film.
#pragma once

#include "inside.h"
#include "tools/measure/detect/screening.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace odraz::measure {

// How a subject is seen: by the film's camera at a time, or by another camera.
struct SubjectCamera {
    double seconds;                    // into the film, for its scenes
    const CameraKey *camera = nullptr; // null: the film's camera
};

struct SubjectName {
    std::string name;
    bool hall;
    std::function<void(Scene &)> pose; // empty: the film poses it
    std::vector<SubjectCamera> cameras;
};

// All subjects, in the order in which they are measured.
const std::vector<SubjectName> &subjectNames();

// A subject and the number of its camera, from 0 on: "A" or "A/2". Throws Refused.
std::pair<SubjectName, size_t> findPicture(const std::string &name);

// Poses the subject in the film's scene; returns its view.
View poseSubject(const SubjectName &name, size_t camera, const IntroSettings &settings, const Film &film);

// A scene, posed for a camera, with all that tracing it needs. Throws std::runtime_error with a line that
// gives the reason.
class Subject {
public:
    Subject(const SubjectName &name, int width, int height);

    void pose(size_t camera);
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
    SubjectName name;
    LoadedFilm film;
    View view = {};
};

} // namespace odraz::measure
