// Conversion between models whose z is up, and cameras and skies, whose y is up.
#pragma once

#include "base/vec3.h"

namespace odraz::radiosity {

// upright() rotates a point or a direction of the model about x so that y is up; asInModel() rotates it back.
inline Vec3 upright(const Vec3 &p, bool upIsZ) { return upIsZ ? Vec3{p.x, p.z, -p.y} : p; }
inline Vec3 asInModel(const Vec3 &p, bool upIsZ) { return upIsZ ? Vec3{p.x, -p.z, p.y} : p; }

} // namespace odraz::radiosity
