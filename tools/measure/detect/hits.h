// Measurements of the film's hits and of its noise.
#pragma once

#include "tools/measure/detect/recording.h"

namespace odraz::measure {

// A scene of the film, all of its shots together, in rows.
struct SceneSpan {
    int scene;
    double from, to;
};
std::vector<SceneSpan> sceneSpans();

// The rows of the film on which a drum is struck, in order.
std::vector<int> hitRows();

// How late a hit is: milliseconds from `at` until 2 ms of sound have nine tenths of the amplitude of the
// strongest 2 ms within the next 100 ms.
double riseTime(const Recording &recording, int64_t at);

// The mean level of [from, to), of both sides, in dB of full scale; -200 for silence.
double level(const Recording &recording, int64_t from, int64_t to);

// Spectral flatness from 2 to 12 kHz: the geometric mean of a spectrum over its arithmetic mean, as the mean
// of all spectra of 4096 samples in [from, to). 0 is for tones, and 0.56 for white noise. Johnston,
// "Transform coding of audio signals using perceptual noise criteria", 1988.
double flatness(const Recording &recording, int64_t from, int64_t to);

} // namespace odraz::measure
