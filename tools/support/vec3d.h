// Vectors of doubles, for reading models and for references that check the engine's floats.
#pragma once

#include "base/vec3.h"

#include <cmath>
#include <compare>
#include <cstddef>

namespace odraz {

struct Vec3d {
    double x, y, z;

    double &operator[](size_t k) { return k == 0 ? x : k == 1 ? y : z; }
    double operator[](size_t k) const { return k == 0 ? x : k == 1 ? y : z; }
    auto operator<=>(const Vec3d &) const = default;
};

inline Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3d operator*(Vec3d a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3d operator*(Vec3d a, Vec3d b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; } // colours
inline Vec3d operator/(Vec3d a, double s) { return {a.x / s, a.y / s, a.z / s}; }
inline double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3d cross(Vec3d a, Vec3d b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3d a) { return std::sqrt(dot(a, a)); }
inline Vec3d normalize(Vec3d a) { return a / length(a); }
inline Vec3d toDouble(const Vec3 &a) { return {(double)a.x, (double)a.y, (double)a.z}; }
inline Vec3 toFloat(const Vec3d &a) { return {(float)a.x, (float)a.y, (float)a.z}; }

} // namespace odraz
