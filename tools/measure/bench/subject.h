// Subjects: the scenes on which the tracer is measured. Some are shared with other tracers, the others are
// the film's.
#pragma once

#include "inside.h"
#include "tools/measure/bench/screening.h"

#include <functional>
#include <string>
#include <vector>

namespace odraz::measure {

struct SubjectName {
    std::string name;
    bool hall;
    std::function<void(Scene &)> pose = {}; // empty: the film poses it
    const CameraKey *camera = nullptr;      // null: the film's camera
    double seconds = 0;                     // time in the film, if the film poses it
};

// All subjects, in the order in which they are measured.
const std::vector<SubjectName> &subjectNames();

// Throws Refused if there is no subject of this name.
SubjectName findSubject(const std::string &name);

// Poses the subject in the film's scene; returns its view.
View poseSubject(const SubjectName &subject, const IntroSettings &settings, const Film &film);

// A posed scene, ready to be traced. The constructor throws std::runtime_error.
class Subject {
public:
    Subject(const SubjectName &name, int width, int height);

    // Traces it on one thread. Returns the processor time in milliseconds.
    double trace(const Quality &quality);
    double samplesPerPixel() const;
    // The traced picture as eight-bit sRGB, clamped at 1, without the film curve: 3 bytes a pixel.
    std::vector<uint8_t> picture() const;
    // Traces a picture with 256 samples in every pixel, on all processors, box-filtered, in the same format.
    std::vector<uint8_t> reference();

private:
    IntroSettings settings;
    Workers workers;
    MeasuredFilm film;
    View view;
};

} // namespace odraz::measure
