// Maps the shapes of an in-between to a traced picture of another moment, and reads the colours there.
#pragma once

#include "trace/picture/between.h"

namespace odraz {

// Maps a pixel (x, y) of an in-between to a pixel of a traced picture. If the shape is hit at s times
// direction(x, y) from the eye, the homogeneous coordinates there are s * (h[0] + h[1] x + h[2] y) + h[3].
struct Carry {
    float h[3][4];  // 0 if that picture's scene lacks the shape
    uint16_t shape; // the shape's index in that scene; kNone: it lacks the shape
};
inline constexpr uint16_t kNone = 0xffff;
// A point is ahead of the eye if its third homogeneous coordinate exceeds this.
inline constexpr float kAhead = 1e-6f;

// Computes the maps of all shapes of `now`, followed by the sky's, to another picture. Its scene may lack
// some shapes and have others. Shapes in both must be in the same order, and have hardly moved.
void carryTo(const Traced &to, const Traced &now, Carry *carry);

// The colours at eight points of a traced picture. coverage: whether the four pixels around each show a
// shape: 0 no, 1 partly, 2 entirely.
struct Fetched {
    Rgb8 radiance;
    Int8 coverage;
};

// Reads the colours at points inside the picture, in pixels from the centre of its first pixel.
Fetched fetch(const Frame &f, int shape, Float8 x, Float8 y);
// Reads the colours for eight pixels of the in-between that show the shape at `along` times direction().
Fetched fetchCarried(const Frame &f, const Carry &c, Float8 px, float py, Float8 along);

} // namespace odraz
