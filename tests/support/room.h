// A room for models: six walls, seen from inside.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Adds a room from corner lo to corner hi. Its charts in order: floor, ceiling, left (-x), right, back (-z),
// front.
inline void addRoom(Model &m, Vec3 lo, Vec3 hi, float element, int walls = 0, int floor = 0) {
    Vec3 x = {hi.x - lo.x, 0, 0}, y = {0, hi.y - lo.y, 0}, z = {0, 0, hi.z - lo.z};
    m.addRect(lo, z, x, floor, element);
    m.addRect(hi, -x, -z, walls, element);
    m.addRect(lo, y, z, walls, element);
    m.addRect(hi, -z, -y, walls, element);
    m.addRect(lo, x, y, walls, element);
    m.addRect(hi, -y, -x, walls, element);
}

} // namespace odraz
