// A camera's path through a shot: keys joined by non-uniform cubic Hermite curves.
//
// The velocity at an inner key is the slope of the parabola through the key and its two neighbours in time,
// so the path is C1 however unevenly the keys are spaced. The first and the last key have no acceleration, so
// shots begin and end in motion; but a value that is the same at the neighbouring key has no velocity. Two
// keys on one row make the velocity there 0: the camera eases to a stop. The pose holds before the first key
// and after the last one. Two keys make a straight path at constant speed, one key a still.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct CameraKey {
    float row;
    Vec3 eye, target; // world units
    float roll;       // degrees; the viewer sees the camera turn clockwise
    float fov;        // vertical field of view in degrees, (0, 170]
};

struct CameraPath {
    const CameraKey *keys;
    int count;
};

template <int N> constexpr CameraPath path(const CameraKey (&keys)[N]) { return {keys, N}; }

// Returns the pose at any finite row, as a key on that row. An empty path looks from the origin along -z.
CameraKey pose(CameraPath path, float row);

} // namespace odraz
