// Single shapes: the distance at which a ray hits one, the surface there, and the shape's box. Rays come in
// packets of eight.
//
// Directions have unit length. A hit counts if 0 < t < kFar; the caller moves origins that lie on a surface
// off it (offsetOrigin). Solid shapes are also hit from inside, at their far side. The formulas suit the
// precision of floats: a sphere is tested by the perpendicular distance from its centre to the ray (Haines,
// Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems,
// 2019), the others by intersecting intervals in their local frames.
#pragma once

#include "trace/scene/bounds.h"
#include "trace/scene/shape.h"

namespace odraz {

struct Ray8 {
    Vec3x8 o, d;
};

// How rays hit rectangles. Seen: from the front, within the outline, as the eye sees them. BothSides: from
// both sides, as they block light. Whole: from both sides, as unbounded planes.
enum class Flat : uint8_t { Seen, Whole, BothSides };

// Distance to one shape, kInfinity for rays that miss it.
Float8 distance(const Shape &shape, const Ray8 &ray, Flat flat = Flat::Seen);

// Distance to a ball of the given radius. f points from its centre to the ray's origin.
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

// The surface at the point that a ray hits.
struct Surface8 {
    Vec3x8 p;  // world; projected onto the shape, so that its error depends on coordinates, not on t
    Vec3x8 n;  // outward unit normal
    Int8 face; // 0 .. 5: which side of a box or cylinder
};
Surface8 surfaceAt(const Shape &shape, const Ray8 &ray, Float8 t);

// The box around a bounded shape.
Bounds boundsOf(const Shape &shape);

// Distance by which a point must be moved off the surface to be certain to lie on one side of it: a few
// rounding errors of the numbers that the point was computed from.
ODRAZ_INLINE Float8 errorBound(Vec3x8 p, Float8 ofShape) { return (sumAbs(p) + ofShape) * 1e-6f + 1e-9f; }
ODRAZ_INLINE float magnitude(const Shape &s) { return sumAbs(s.centre) + maxComponent(s.half); }

// Returns an origin for rays that is certain to lie on one side of the surface: +1 along n, -1 against it.
inline Vec3x8 offsetOrigin(const Shape &s, const Surface8 &at, Float8 side) {
    return fmadd(at.n, errorBound(at.p, broadcast(magnitude(s))) * side, at.p);
}

} // namespace odraz
