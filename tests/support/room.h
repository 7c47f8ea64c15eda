// A room for models: six walls, seen from inside; and the closed form of a form factor.
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

// Returns the form factor from the point (x, z) on a plane to the rectangle [x0, x1] x [z0, z1] at height c
// above it. Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-11.
inline double parallelFormFactor(double x, double z, double x0, double x1, double z0, double z1, double c) {
    auto corner = [&](double u, double v) { // with one corner straight above the point
        double a = std::fabs(u) / c, b = std::fabs(v) / c, ra = std::sqrt(1 + a * a),
               rb = std::sqrt(1 + b * b);
        return std::copysign((a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb)) / (2 * M_PI), u * v);
    };
    return corner(x1 - x, z1 - z) - corner(x0 - x, z1 - z) - corner(x1 - x, z0 - z) + corner(x0 - x, z0 - z);
}

} // namespace odraz
