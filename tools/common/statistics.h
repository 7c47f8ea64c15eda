// Figures that stand for many.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace odraz {

// The value that the given share (0 .. 1) of the others do not exceed; there must be one.
template <class T> T quantile(std::vector<T> values, double share) {
    auto at = values.begin() + (long)((double)(values.size() - 1) * share);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

template <class T> T median(std::vector<T> values) { return quantile(std::move(values), 0.5); }

// Peak signal-to-noise ratio of eight-bit values that differ by these squares in sum, in dB; infinite where
// none differs.
inline double psnr(double squares, size_t count) {
    return squares > 0 ? 10 * std::log10(255. * 255. * (double)count / squares) : INFINITY;
}

// Of as many values in both.
inline double psnr(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b) {
    double squares = 0;
    for (size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
    return psnr(squares, a.size());
}

} // namespace odraz
