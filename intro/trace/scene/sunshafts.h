// Shafts of sun: the light that dust scatters to the eye where a sun, far away, shines into a room.
//
// The openings stand side by side in one wall, the room lies on the side of larger x. Along the sun each
// makes a sheared prism, from which upright columns cut their shadows. World units; radiance a unit.
#pragma once

#include "trace/scene/bounds.h"

namespace odraz {

inline constexpr int kMaxOpenings = 5, kMaxPillars = 8;

struct Sunshafts {
    int openings, pillars;                      // none: there are no shafts
    Vec3 sun;                                   // towards it, unit; -x
    Bounds room;                                // where there is dust; the openings are in its wall lo.x
    float low, high;                            // of all openings in y
    float from[kMaxOpenings], to[kMaxOpenings]; // in z
    float pillarX[kMaxPillars], pillarZ[kMaxPillars]; // the columns' axes, and
    float pillarRadius;
    Rgb scatter; // what a unit of a shaft shows, seen across the sun's direction
    float drift; // of the dust's clouds
};

} // namespace odraz
