// The camera: from picture coordinates to rays, and from points to picture coordinates.
#pragma once

#include "trace/rays/intersect.h"

namespace odraz {

struct View {
    Vec3 eye;
    Vec3 forward;        // unit
    Vec3 right, down;    // across the whole picture, at distance 1
    float width, height; // size of the picture in pixels
    float spread;        // growth of a pixel's width per unit of distance

    // The direction (of any length) through the point (x, y) of the picture, in pixels from its top left.
    template <class T> Vec3T<T> direction(T x, T y) const {
        T u = x * (1.f / width) - 0.5f, v = y * (1.f / height) - 0.5f;
        return {fmadd(u, right.x, fmadd(v, down.x, forward.x)),
                fmadd(u, right.y, fmadd(v, down.y, forward.y)),
                fmadd(u, right.z, fmadd(v, down.z, forward.z))};
    }

    // ahead() returns how far a point is ahead of the eye, along `forward`, in world units. project()
    // computes its position in the picture, in pixels; it is valid only for points ahead of the eye.
    float ahead(const Vec3 &p) const { return dot(p - eye, forward); }
    void project(const Vec3 &p, float &x, float &y) const {
        Vec3 to = p - eye;
        float inverse = 1 / ahead(p);
        x = fmadd(dot(to, right) * inverse, width / dot(right, right), width * 0.5f);
        y = fmadd(dot(to, down) * inverse, height / dot(down, down), height * 0.5f);
    }
};

// The view from `eye` to `target`. `roll` and `fov`, the vertical field of view (0, 170], are in degrees. If
// target and eye are equal, the view is along -z. In a view straight up, z points to the picture's upper
// edge; in a view straight down, -z.
View lookAt(const Vec3 &eye, const Vec3 &target, float roll, float fov, int width, int height);

} // namespace odraz
