// The camera as the tracer sees it: from picture coordinates to rays.
#pragma once

#include "trace/rays/intersect.h"

namespace odraz {

struct View {
    Vec3 eye;
    Vec3 forward;        // unit
    Vec3 right, down;    // across the whole picture, at distance 1
    float width, height; // of the picture in pixels
    float spread;        // how much a pixel widens per unit of distance

    // The direction (not of unit length) through the point (x, y) of the picture, in pixels from its top
    // left.
    template <class T> Vec3T<T> direction(T x, T y) const {
        T u = x * (1.f / width) - 0.5f, v = y * (1.f / height) - 0.5f;
        return {fmadd(u, right.x, fmadd(v, down.x, forward.x)),
                fmadd(u, right.y, fmadd(v, down.y, forward.y)),
                fmadd(u, right.z, fmadd(v, down.z, forward.z))};
    }

    // How far ahead of the eye a point lies, in world units, and its position in the picture, in pixels.
    // project() is valid only for points ahead of the eye.
    float ahead(const Vec3 &p) const { return dot(p - eye, forward); }
    void project(const Vec3 &p, float &x, float &y) const {
        Vec3 to = p - eye;
        float inverse = 1 / ahead(p);
        x = fmadd(dot(to, right) * inverse, width / dot(right, right), width * 0.5f);
        y = fmadd(dot(to, down) * inverse, height / dot(down, down), height * 0.5f);
    }
};

// The view from `eye` to `target`. Roll in degrees, vertical field of view in degrees (0, 170]. There is
// always a picture: if target and eye are equal, the view is along -z. In a view straight up, z is at the
// picture's upper edge; in a view straight down, -z.
View lookAt(const Vec3 &eye, const Vec3 &target, float roll, float fov, int width, int height);

} // namespace odraz
