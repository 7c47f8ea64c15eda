// Shafts of sunlight: the sun shines into a room, and dust there scatters its light to the eye.
//
// The openings are side by side in one wall; the room is on the side of larger x. Through each opening the
// sun lights a sheared prism, in which upright columns cast shadows. Lengths are in world units.
#pragma once

#include "trace/scene/bounds.h"

namespace odraz {

inline constexpr int kMaxOpenings = 5, kMaxPillars = 8;

struct Sunshafts {
    int openings, pillars;                      // no openings: no shafts
    Vec3 sun;                                   // unit, towards the sun; x < 0
    Bounds room;                                // where there is dust; the openings are in the wall at lo.x
    float low, high;                            // y at the lower and upper edge of all openings
    float from[kMaxOpenings], to[kMaxOpenings]; // z at the sides of each opening
    float pillarX[kMaxPillars], pillarZ[kMaxPillars]; // the columns' axes
    float pillarRadius;
    Rgb scatter; // radiance per unit of a shaft, seen across the sun's direction
    float drift; // distance that the clouds of dust have moved
};

} // namespace odraz
