// Sparks: one to three pixels together that are much brighter than all around them, and gone a moment later
// or before. A bright point that stays where it is, or moves on with its ball, is none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace odraz {

// Brightness, 0 .. 255.
struct Grey {
    int width = 0, height = 0;
    std::vector<uint8_t> level; // top row first

    int at(int x, int y) const { return level[(std::size_t)y * (size_t)width + (size_t)x]; }
};
// Of pixels of three or four bytes, red, green and blue first: their mean.
Grey greyOf(int width, int height, const uint8_t *pixels, int bytesPerPixel);

struct Spark {
    int x, y;
    int surround; // the brightest level three pixels away from it
    int over;     // how many levels it is above that
};

// The points of a picture that stand alone: at least `least` levels above everything three pixels away, and
// at most three pixels of those between are more than half as high. Up to a pixel of the picture's border.
std::vector<Spark> pointsOf(const Grey &picture, int least);

// Whether a neighbouring picture shows nothing half as high within `reach` pixels of a point.
bool missing(const Spark &spark, const Grey &neighbour, int reach);

// Whether two pictures are so much alike that a point of one is looked for in the other: no cut between them.
bool alike(const Grey &a, const Grey &b);

// The points of a picture that one of its neighbours lacks. Either may be null: there is none.
std::vector<Spark> sparksOf(const std::vector<Spark> &points, const Grey &picture, const Grey *before,
                            const Grey *after, int reach);

} // namespace odraz
