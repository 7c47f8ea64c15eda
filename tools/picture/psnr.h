// The peak signal-to-noise ratio (PSNR), and the sRGB curve for PSNR in linear light.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pictures {

// PSNR, in dB, of `count` eight-bit values whose squared differences have the sum `squares`. Infinite if no
// value differs.
inline double psnr(double squares, size_t count) {
    return squares > 0 ? 10 * std::log10(255. * 255. * (double)count / squares) : INFINITY;
}

// Converts an sRGB value (IEC 61966-2-1) to linear light; both 0 .. 1.
inline double linearOfSrgb(double x) { return x > 0.04045 ? std::pow((x + 0.055) / 1.055, 2.4) : x / 12.92; }

// Converts an eight-bit sRGB value to linear light.
inline double linearOfSrgb(uint8_t value) {
    static const std::vector<double> all = [] {
        std::vector<double> v(256);
        for (size_t i = 0; i < v.size(); ++i) v[i] = linearOfSrgb((double)i / 255);
        return v;
    }();
    return all[value];
}

// Converts linear light to sRGB, 0 .. 1, not rounded to eight bits.
inline float srgbOfLinear(float x) {
    x = std::clamp(x, 0.f, 1.f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

// The sum of the squared differences of eight-bit sRGB values, and the same in linear light, which weighs
// bright pixels more. Both vectors have the same size.
inline double squares(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}
inline double linearSquares(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        double d = (linearOfSrgb(a[i]) - linearOfSrgb(b[i])) * 255;
        sum += d * d;
    }
    return sum;
}

// PSNR of two vectors of the same size, as they are and in linear light.
inline double psnr(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b) {
    return psnr(squares(a, b), a.size());
}
inline double linearPsnr(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b) {
    return psnr(linearSquares(a, b), a.size());
}

} // namespace pictures
