// A recording written by odraz --wav, and measurements of any part of it.
#pragma once

#include <complex>
#include <string>
#include <vector>

namespace odraz::measure {

struct Recording {
    int rate = 0;               // samples a second
    std::vector<float> side[2]; // left and right, -1 .. 1

    size_t size() const { return side[0].size(); } // samples per side
};

// Reads a WAV file with two channels of 16 bits. Throws Refused (command_line.h) for any other file.
Recording readWav(const std::string &path);

// The discrete Fourier transform in place; the size must be a power of two. Cooley and Tukey, 1965.
void fourier(std::vector<std::complex<double>> &x);

// The power spectrum of `size` samples from `from` on, under a Hann window: size / 2 bins of rate / size Hz,
// summed over both sides. A sine of amplitude 1 on one side has a total of 1/4. Samples outside the recording
// are silent.
std::vector<double> spectrum(const Recording &recording, int64_t from, int size);

// Spectral flux at the sample `at`: the rise of the logarithmic spectrum over `step` samples, summed over
// bands of a third of an octave. Masri, "Computer modelling of sound for transformation and synthesis of
// musical signals", 1996.
double flux(const Recording &recording, int64_t at, int step);

} // namespace odraz::measure
