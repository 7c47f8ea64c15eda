// A recording by odraz --wav, and measurements of any part of it.
#pragma once

#include <complex>
#include <string>
#include <vector>

namespace odraz::measure {

struct Recording {
    int rate = 0;               // samples a second
    std::vector<float> side[2]; // left and right, -1 .. 1

    size_t size() const { return side[0].size(); } // samples of each side
};

// Reads a WAV of two channels of 16 bits. Throws Refused (command_line.h) for anything else.
Recording readWav(const std::string &path);

// The discrete Fourier transform in place; the size must be a power of two. Cooley and Tukey, 1965.
void fourier(std::vector<std::complex<double>> &x);

// The energy of `size` samples from `from` on, under a Hann window, in size / 2 bins of rate / size Hz: power
// in a bin, summed over both sides. A sine of amplitude 1 on one side has a total of 1/4. Outside the
// recording there is silence.
std::vector<double> spectrum(const Recording &recording, int64_t from, int size);

// How much new sound begins at `at`: the rise of the logarithmic spectrum over `apart` samples, summed over
// bands of a third of an octave. Masri, "Computer modelling of sound for transformation and synthesis of
// musical signals", 1996.
double flux(const Recording &recording, int64_t at, int apart);

} // namespace odraz::measure
