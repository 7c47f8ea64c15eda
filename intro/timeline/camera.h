// The camera's way through a shot: keys joined by non-uniform cubic Hermite curves.
//
// Velocity at an inner key is that of the parabola through it and its two neighbours in time (so the path is
// C1 however unevenly the keys stand); at the first and the last key there is no acceleration: shots begin
// and end in motion. A key that stands twice eases: what does not change between two keys rests. Before the
// first and after the last key the pose holds. Two keys make a straight and even way, one a still.
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

// The pose at a row, as a key of that row; any finite row. An empty path looks from the origin along -z.
CameraKey pose(CameraPath path, double row);

} // namespace odraz
