// The light that a ray gathers from shafts of sun on its way to the eye.
#pragma once

#include "trace/scene/sunshafts.h"

namespace odraz {

// For rays o + t d (unit d), 0 <= t <= hit, in closed form. Each point of the ray is slid along the sun's
// direction onto the wall with the openings. There it moves straight and evenly as t grows. So it passes
// every opening, and every column's shadow, in one stretch of t. Columns count as if they were as high as the
// room.
Rgb8 shaftLight(const Sunshafts &shafts, const Vec3x8 &o, const Vec3x8 &d, Float8 hit);

} // namespace odraz
