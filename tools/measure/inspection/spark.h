// Sparks: one to three adjacent pixels that are much brighter than their surroundings, and that the picture
// before or after does not show. A bright point that stays, or moves with its ball, is not a spark.
#pragma once

#include <cstdint>
#include <vector>

namespace odraz::measure {

// Brightness, 0 .. 255.
struct Grey {
    int width = 0, height = 0;
    std::vector<uint8_t> level; // top row first

    int at(int x, int y) const { return level[(size_t)y * (size_t)width + (size_t)x]; }
};
// The mean of red, green and blue in pixels of four bytes.
Grey greyOf(int width, int height, const uint8_t *rgba);

struct Spark {
    int x, y;
    int surround; // the brightest level three pixels away
    int over;     // levels above `surround`
};

// The bright points of a picture. Each is at least `least` levels above all pixels three pixels away, and at
// most three pixels within that distance are above half of this height. The outermost pixels are left out.
std::vector<Spark> pointsOf(const Grey &picture, int least);

// The points of a picture that the picture before or after lacks: within `reach` pixels that picture has no
// pixel of at least half the height. A picture that is null, or of another shot, does not count.
std::vector<Spark> sparksOf(const std::vector<Spark> &points, const Grey &picture, const Grey *before,
                            const Grey *after, int reach);

} // namespace odraz::measure
