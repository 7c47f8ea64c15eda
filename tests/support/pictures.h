// What pictures hold, row by row, as lists; and qualities by their names.
#pragma once

#include "intro.h"
#include "trace/picture/frame.h"
#include "trace/quality.h"

namespace odraz {

inline const Quality &named(QualityName name) { return kQualities[(int)name]; }

// Red, green, blue and 255 of each pixel.
inline std::vector<uint8_t> bytesOf(const Picture &p) { return {p.rgba, p.rgba + p.width * p.height * 4}; }

// The radiance of one plane: 0 red, 1 green, 2 blue.
inline std::vector<float> planeOf(const Frame &f, int c) {
    std::vector<float> all;
    for (int y = 0; y < f.height; ++y) {
        const float *row = f.plane[c] + (size_t)y * (size_t)f.stride;
        all.insert(all.end(), row, row + f.width);
    }
    return all;
}

// Red, then green, then blue.
inline std::vector<float> planesOf(const Frame &f) {
    std::vector<float> all;
    for (int c = 0; c < 3; ++c)
        for (float v : planeOf(f, c)) all.push_back(v);
    return all;
}

} // namespace odraz
