// Random numbers, places and directions for tests of the tracer, the same in every run.
#pragma once

#include "base/vec3.h"

#include <random>

namespace odraz {

// Sets one of eight vectors.
inline void setLane(Vec3x8 &v, int k, Vec3 to) { v.x[k] = to.x, v.y[k] = to.y, v.z[k] = to.z; }

struct Dice {
    std::mt19937 engine;

    explicit Dice(unsigned seed) : engine(seed) {}
    float operator()(float lo, float hi) { return std::uniform_real_distribution<float>(lo, hi)(engine); }
    // In a cube about the origin, whose sides are twice `size`.
    Vec3 point(float size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
    Vec3 direction() {
        for (;;) {
            Vec3 v = point(1);
            float n = dot(v, v);
            if (n > 0.01f && n < 1) return normalize(v);
        }
    }
    // A direction at right angles to another.
    Vec3 across(Vec3 d) { return normalize(cross(d, direction())); }
    Mat3 rotation() {
        Vec3 u = direction(), v = across(u);
        return {u, v, cross(u, v)};
    }
};

} // namespace odraz
