// What was written by odraz --wav, and what can be said about any stretch of it.
#pragma once

#include <complex>
#include <string>
#include <vector>

namespace odraz {

struct Recording {
    int rate = 0;               // samples a second
    std::vector<float> side[2]; // left and right, -1 .. 1

    size_t size() const { return side[0].size(); } // samples of each
};

// A WAV of two channels of 16 bits. Throws Refused (arguments.h) for anything else.
Recording readWav(const std::string &path);

// The discrete Fourier transform in place; the size is a power of two. Cooley and Tukey, 1965.
void fourier(std::vector<std::complex<double>> &x);

// Energy (power in a bin, summed over both sides) of `size` samples from `from` on, under a window of von
// Hann, in size / 2 bins of rate / size Hz. A sine of amplitude 1 on one side has 1/4 in all. Outside the
// recording there is silence.
std::vector<double> spectrum(const Recording &recording, int64_t from, int size);

// How much comes in anew at a time: the rise of the logarithmic spectrum over `apart` samples, summed over
// bands of a third of an octave. Masri, "Computer modelling of sound for transformation and synthesis of
// musical signals", 1996.
double flux(const Recording &recording, int64_t at, int apart);

} // namespace odraz
