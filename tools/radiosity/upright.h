// Models whose z is up, for what has y up: cameras and skies.
#pragma once

#include "base/vec3.h"

namespace odraz {

// A place or a direction of the model with y up and x as it was; and back.
inline Vec3 upright(const Vec3 &p, bool upIsZ) { return upIsZ ? Vec3{p.x, p.z, -p.y} : p; }
inline Vec3 asInModel(const Vec3 &p, bool upIsZ) { return upIsZ ? Vec3{p.x, -p.z, p.y} : p; }

} // namespace odraz
