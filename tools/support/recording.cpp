#include "tools/support/recording.h"

#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace odraz::measure {

Recording readWav(const std::string &path) {
    std::string file = common::readWhole(path);
    uint16_t format[8];
    if (file.size() < 44 || file.compare(0, 4, "RIFF") || file.compare(8, 8, "WAVEfmt ") ||
        file.compare(36, 4, "data"))
        throw common::Refused(path + ": not a plain WAV file: write it with odraz --wav");
    std::memcpy(format, &file[20], sizeof format);
    if (format[0] != 1 || format[1] != 2 || format[7] != 16)
        throw common::Refused(path + ": needs two channels of 16 bits");
    Recording r;
    uint32_t rate;
    std::memcpy(&rate, &file[24], sizeof rate);
    r.rate = (int)rate;
    for (size_t at = 44; at + 4 <= file.size(); at += 4) {
        int16_t pair[2];
        std::memcpy(pair, &file[at], sizeof pair);
        for (int c = 0; c < 2; ++c) r.side[c].push_back((float)pair[c] / 32768.f);
    }
    return r;
}

void fourier(std::vector<std::complex<double>> &x) {
    size_t n = x.size();
    for (size_t i = 1, j = 0; i < n; ++i) {
        size_t bit = n >> 1;
        for (; j & bit; bit >>= 1) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(x[i], x[j]);
    }
    for (size_t size = 2; size <= n; size *= 2) {
        std::vector<std::complex<double>> turn(size / 2);
        for (size_t i = 0; i < size / 2; ++i) turn[i] = std::polar(1., -2 * M_PI * (double)i / (double)size);
        for (size_t from = 0; from < n; from += size)
            for (size_t i = 0; i < size / 2; ++i) {
                std::complex<double> a = x[from + i], b = x[from + i + size / 2] * turn[i];
                x[from + i] = a + b;
                x[from + i + size / 2] = a - b;
            }
    }
}

std::vector<double> spectrum(const Recording &r, int64_t from, int size) {
    // Transform both sides at once, as the real and the imaginary part of one signal
    std::vector<std::complex<double>> x((size_t)size);
    for (int i = 0; i < size; ++i) {
        int64_t at = from + i;
        if (at < 0 || at >= (int64_t)r.size()) continue;
        double window = 0.5 - 0.5 * std::cos(2 * M_PI * i / size);
        x[(size_t)i] = std::complex<double>(r.side[0][(size_t)at], r.side[1][(size_t)at]) * window;
    }
    fourier(x);
    std::vector<double> energy((size_t)size / 2);
    double scale = 1. / ((double)size * size) / 0.375;
    for (size_t i = 1; i < energy.size(); ++i)
        energy[i] = (std::norm(x[i]) + std::norm(x[(size_t)size - i])) * scale * 0.5 * 2;
    return energy;
}

double flux(const Recording &r, int64_t at, int step) {
    constexpr int kSize = 1024;
    std::vector<double> before = spectrum(r, at - kSize, kSize),
                        after = spectrum(r, at - kSize + step, kSize);
    double sum = 0;
    for (double low = 60; low < 16000; low *= 1.2599) {
        double a = 1e-9, b = 1e-9;
        size_t from = (size_t)(low * kSize / r.rate),
               to = std::max(from + 1, (size_t)(low * 1.2599 * kSize / r.rate));
        for (size_t i = from; i < to; ++i) a += before[i], b += after[i];
        sum += std::max(0., std::log10(b / a));
    }
    return sum;
}

} // namespace odraz::measure
