// What a ray to the eye gathers in shafts of sun.
#pragma once

#include "trace/scene/sunshafts.h"

namespace odraz {

// Of rays o + t d (unit d), 0 <= t <= hit. In closed form: slid along the sun onto the openings' wall, a
// point of the ray moves straight and evenly, so that it passes every opening, and every column's shadow,
// in one stretch of t. That shadow is as long as the room is high.
Rgb8 gatherShafts(const Sunshafts &shafts, const Vec3x8 &o, const Vec3x8 &d, Float8 hit);

} // namespace odraz
