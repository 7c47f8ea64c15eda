// Lists of the radiance of a traced picture, row by row.
#pragma once

#include "trace/picture/frame.h"

#include <vector>

namespace odraz {

// One plane: 0 red, 1 green, 2 blue.
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
