// Axis-aligned bounding boxes, in world coordinates.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct Bounds {
    Vec3 lo, hi;
};
inline constexpr Bounds kNoBounds = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

inline Vec3 lower(Vec3 a, Vec3 b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
inline Vec3 upper(Vec3 a, Vec3 b) { return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }
inline void include(Bounds &b, const Bounds &more) { b = {lower(b.lo, more.lo), upper(b.hi, more.hi)}; }

} // namespace odraz
