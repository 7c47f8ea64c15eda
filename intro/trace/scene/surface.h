// Single shapes: how far along a ray they are met, what lies there, and how far they reach. Rays come by
// eight.
//
// Directions have unit length. A hit counts at t > 0 and t < kFar; origins on surfaces are moved off them by
// the caller (offsetOrigin). Solid shapes are met from inside too, at their far side. The forms are chosen
// for floats: a sphere is judged by the perpendicular distance from its centre to the ray (Haines, Guenther
// and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019), the
// others as intersections of intervals in their local frames.
#pragma once

#include "trace/scene/bounds.h"
#include "trace/scene/shape.h"

namespace odraz {

struct Ray8 {
    Vec3x8 o, d;
};

// How flat shapes are taken: as the eye sees them; without outline, as planes; or, for light, rectangles from
// both sides.
enum class Flat : uint8_t { Seen, Whole, BothSides };

// Distance to one shape, kInfinity where it is missed.
Float8 distance(const Shape &shape, const Ray8 &ray, Flat flat = Flat::Seen);

// ... to a ball of the given radius, whose centre lies at -f from the ray's origin.
template <class F, class R> ODRAZ_INLINE Float8 hitBall(Vec3T<F> f, R radius, Vec3x8 d) {
    Float8 b = -dot(d, f);
    Vec3x8 perpendicular = {fmadd(d.x, b, f.x), fmadd(d.y, b, f.y), fmadd(d.z, b, f.z)};
    Float8 discriminant = radius * radius - dot(perpendicular, perpendicular);
    if (!any(discriminant >= 0.f)) return broadcast(kInfinity);
    Float8 root = sqrt(max(discriminant, 0.f)), near = b - root, far = b + root;
    Float8 t = select(near > 0.f, near, far);
    return select((discriminant >= 0.f) & (t > 0.f) & (t < kFar), t, kInfinity);
}
ODRAZ_INLINE Float8 hitSphere(const Shape &s, const Ray8 &ray) {
    return hitBall(ray.o - s.centre, s.half.x, ray.d);
}
// Most shapes are balls: their test is worth having in a loop.
ODRAZ_INLINE Float8 distanceTo(const Shape &s, const Ray8 &ray, Flat flat = Flat::Seen) {
    return s.isBall() ? hitSphere(s, ray) : distance(s, ray, flat);
}

// The place that a ray meets.
struct Surface8 {
    Vec3x8 p;  // world, projected back onto the shape: its error depends on coordinates, not on t
    Vec3x8 n;  // outward unit normal
    Int8 face; // 0..6: which side of a box or cylinder
};
Surface8 surfaceAt(const Shape &shape, const Ray8 &ray, Float8 t);

// The box around a bounded shape.
Bounds boundsOf(const Shape &shape);

// How far off the surface a point must be put to lie surely on its side: a few roundings of every magnitude
// that entered it.
ODRAZ_INLINE Float8 errorBound(Vec3x8 p, Float8 ofShape) { return (sumAbs(p) + ofShape) * 1e-6f + 1e-9f; }
ODRAZ_INLINE float magnitude(const Shape &s) { return sumAbs(s.centre) + maxComponent(s.half); }

// An origin that lies surely on the side of the surface to which `side` points (+1 along n, -1 against it).
inline Vec3x8 offsetOrigin(const Shape &s, const Surface8 &at, Float8 side) {
    return fmadd(at.n, errorBound(at.p, broadcast(magnitude(s))) * side, at.p);
}

} // namespace odraz
