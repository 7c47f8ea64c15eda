// The light that dust in shafts of sunlight scatters along a ray.
#pragma once

#include "trace/scene/sunshafts.h"

namespace odraz {

// For rays o + t d (unit d), 0 <= t <= hit, in closed form. Each point of the ray is projected along the
// sun's direction to the wall with the openings, where it moves at constant speed as t grows. So it passes
// every opening, and every column's shadow, in one interval of t. Columns are as high as the room.
Rgb8 shaftLight(const Sunshafts &shafts, const Vec3x8 &o, const Vec3x8 &d, Float8 hit);

} // namespace odraz
