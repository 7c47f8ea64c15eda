// Random numbers, points and directions, the same in every run.
#pragma once

#include "base/vec3.h"

namespace odraz {

// Sets vector k of eight.
inline void setLane(Vec3x8 &v, int k, Vec3 to) { v.x[k] = to.x, v.y[k] = to.y, v.z[k] = to.z; }

struct Dice {
    std::mt19937 engine;

    explicit Dice(unsigned seed) : engine(seed) {}
    float operator()(float lo, float hi) { return std::uniform_real_distribution<float>(lo, hi)(engine); }
    // A point in the cube from -size to size on every axis.
    Vec3 point(float size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
    Vec3 direction() {
        for (;;) {
            Vec3 v = point(1);
            float n = dot(v, v);
            if (n > 0.01f && n < 1) return normalize(v);
        }
    }
    // A direction perpendicular to d.
    Vec3 perpendicular(Vec3 d) { return normalize(cross(d, direction())); }
    Mat3 rotation() {
        Vec3 u = direction(), v = perpendicular(u);
        return {u, v, cross(u, v)};
    }
};

} // namespace odraz
