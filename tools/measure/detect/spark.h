// Sparks: one to three adjacent pixels that are much brighter than all around them, and that the picture
// before or after does not show. A bright point that stays, or moves with its ball, is not a spark.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace odraz::measure {

// Brightness, 0 .. 255.
struct Grey {
    int width = 0, height = 0;
    std::vector<uint8_t> level; // top row first

    int at(int x, int y) const { return level[(std::size_t)y * (size_t)width + (size_t)x]; }
};
// The mean of red, green and blue, which come first in each pixel of three or four bytes.
Grey greyOf(int width, int height, const uint8_t *pixels, int bytesPerPixel);

struct Spark {
    int x, y;
    int surround; // the brightest level three pixels away from it
    int over;     // how many levels it is above `surround`
};

// The bright points of a picture: each is at least `least` levels above everything three pixels away, and
// within that distance at most three pixels are more than half as high. Leaves out the outermost pixels.
std::vector<Spark> pointsOf(const Grey &picture, int least);

// Whether a neighbouring picture has nothing at least half as high within `reach` pixels of the point.
bool missing(const Spark &spark, const Grey &neighbour, int reach);

// Whether two pictures are so similar that they are of one shot, so that a point of one can be sought in the
// other.
bool alike(const Grey &a, const Grey &b);

// The points of a picture that at least one of its neighbours lacks. A neighbour may be null: there is none.
std::vector<Spark> sparksOf(const std::vector<Spark> &points, const Grey &picture, const Grey *before,
                            const Grey *after, int reach);

} // namespace odraz::measure
