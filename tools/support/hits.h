// Measurements of the film's drum hits and of noise in its music.
#pragma once

#include "tools/support/recording.h"

namespace odraz::measure {

// The rows of a scene, from the start of its first shot to the end of its last one.
struct SceneSpan {
    int scene;
    double from, to;
};
std::vector<SceneSpan> sceneSpans();

// The rows on which a drum is struck, in order.
std::vector<int> hitRows();

// The rise time of a hit: milliseconds from the sample `at` until a window of 2 ms has nine tenths of the
// amplitude of the loudest such window within 100 ms.
double riseTime(const Recording &recording, int64_t at);

// The mean level of both sides over the samples [from, to), in dB of full scale; -200 for silence.
double level(const Recording &recording, int64_t from, int64_t to);

// Spectral flatness from 2 to 12 kHz: the geometric mean of a spectrum over its arithmetic mean, averaged
// over all spectra of 4096 samples in [from, to). It is 0 for tones and 0.56 for white noise. Johnston,
// "Transform coding of audio signals using perceptual noise criteria", 1988.
double flatness(const Recording &recording, int64_t from, int64_t to);

} // namespace odraz::measure
