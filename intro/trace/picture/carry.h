// How the shapes of an in-between are carried to a traced picture of another moment, and what that shows
// there.
#pragma once

#include "trace/picture/between.h"

namespace odraz {

// Maps a pixel (x, y) of an in-between to a pixel of a traced picture. If the shape is hit at s times
// direction(x, y) from the eye, the homogeneous coordinates there are s * (h[0] + h[1] x + h[2] y) + h[3].
struct Carry {
    float h[3][4];  // 0 if it is not there
    uint16_t shape; // its index in that picture's scene; kNone: it is not there
};
inline constexpr uint16_t kNone = 0xffff;
// Homogeneous coordinates are ahead of the eye from here on.
inline constexpr float kAhead = 1e-6f;

// How all shapes of `now`, and behind the last of them the sky, map to another picture. Its scene may have
// some more shapes and lack some others, but their order is the same. A shape that is in both has hardly
// moved.
void carryTo(const Traced &to, const Traced &now, Carry *carry);

// What a traced picture shows at eight places of a shape: radiance, and whether it is the shape's: 0 no, 1
// partly, 2 entirely.
struct Fetched {
    Rgb8 radiance;
    Int8 worth;
};

// Places are in pixels from the middle of the picture's first one, and inside.
Fetched fetch(const Frame &f, int shape, Float8 x, Float8 y);
// Eight pixels of the in-between, which show the shape `far` along their directions.
Fetched fetchFar(const Frame &f, const Carry &c, Float8 px, float py, Float8 far);

} // namespace odraz
