// Rounds the numbers of a key to fewer bits, so that they pack well. Viewers see whether a path is smooth,
// but not whether a key is a millimetre off.
#pragma once

#include "base/float8.h"
#include "timeline/camera.h"

#include <initializer_list>

namespace odraz {

// Returns the key with `count` significant bits, up to 24, in each number except row and roll.
constexpr CameraKey withBits(CameraKey key, int count) {
    int unit = 1 << (24 - count);
    for (float *x :
         {&key.eye.x, &key.eye.y, &key.eye.z, &key.target.x, &key.target.y, &key.target.z, &key.fov})
        *x = fromBits((bits(*x) + unit / 2) & -unit);
    return key;
}

} // namespace odraz
