// Shafts of sunlight: a far sun shines into a room, and dust there scatters its light to the eye.
//
// The openings stand side by side in one wall; the room lies on the side of larger x. The sun behind each
// opening lights a sheared prism, in which upright columns cast shadows. World units; radiance per unit.
#pragma once

#include "trace/scene/bounds.h"

namespace odraz {

inline constexpr int kMaxOpenings = 5, kMaxPillars = 8;

struct Sunshafts {
    int openings, pillars;                      // no openings: no shafts
    Vec3 sun;                                   // unit, towards the sun; x < 0
    Bounds room;                                // where there is dust; the openings are in the wall at lo.x
    float low, high;                            // of all openings, in y
    float from[kMaxOpenings], to[kMaxOpenings]; // of each opening, in z
    float pillarX[kMaxPillars], pillarZ[kMaxPillars]; // the columns' axes
    float pillarRadius;
    Rgb scatter; // radiance per unit of a shaft, seen across the sun's direction
    float drift; // how far the dust's clouds have moved
};

} // namespace odraz
