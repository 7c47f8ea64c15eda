// The camera's path through a shot: keys joined by non-uniform cubic Hermite curves.
//
// The velocity at an inner key is that of the parabola through the key and its two neighbours in time. So the
// path is C1 however unevenly the keys are spaced. At the first and the last key there is no acceleration:
// shots begin and end in motion, but a value that does not change up to the neighbouring key rests. Two keys
// on one row make the velocity there 0: the camera eases to a stop. Before the first key and after the last
// one the pose holds. Two keys make a straight path at even speed, one key a still.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct CameraKey {
    float row;
    Vec3 eye, target; // world units
    float roll;       // degrees, clockwise as the viewer sees the camera turn
    float fov;        // vertical field of view in degrees, (0, 170]
};

struct CameraPath {
    const CameraKey *keys;
    int count;
};

template <int N> constexpr CameraPath path(const CameraKey (&keys)[N]) { return {keys, N}; }

// The pose at any finite row, returned as a key of that row. An empty path looks from the origin along -z.
CameraKey pose(CameraPath path, float row);

} // namespace odraz
