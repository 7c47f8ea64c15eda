#include "trace/scene/surface.h"

#include <initializer_list>

namespace odraz {

// The stretch of a ray inside a convex solid; empty if enter > leave.
struct Interval {
    Float8 enter, leave;
};

static Float8 nearest(Interval i) {
    Float8 t = select(i.enter > 0.f, i.enter, i.leave);
    return select((i.enter <= i.leave) & (t > 0.f) & (t < kFar), t, kInfinity);
}

// Where o + t d is between -half and +half, in one coordinate. A zero direction becomes tiny, to avoid NaN.
static Interval slab(Float8 o, Float8 d, float half) {
    Int8 tiny = abs(d) < 1e-20f;
    Float8 inverse = 1.f / select(tiny, 1e-20f, d);
    Float8 a = (-half - o) * inverse, b = (half - o) * inverse;
    return {min(a, b), max(a, b)};
}

static Interval overlap(Interval a, Interval b) { return {max(a.enter, b.enter), min(a.leave, b.leave)}; }

static Float8 hitPlane(Float8 height, Float8 slope) {
    Float8 t = -height / slope;
    return select((t > 0.f) & (t < kFar), t, kInfinity);
}

// Width that is added to a rectangle on each side: more than the rounding error of a point on it. So
// neighbours overlap, and no ray passes between them.
static float slackOf(const Shape &s) { return (sumAbs(s.centre) + s.half.x + s.half.z) * 5e-7f; }

static Float8 hitRect(const Shape &s, const Vec3x8 &o, const Vec3x8 &d, bool bothSides) {
    Float8 t = hitPlane(o.y, d.y);
    if (!bothSides) t = select(d.y < 0.f, t, kInfinity);
    Float8 finite = select(t < kInfinity, t, 0.f);
    float slack = slackOf(s);
    Int8 inside = (abs(fmadd(finite, d.x, o.x)) <= s.half.x + slack) &
                  (abs(fmadd(finite, d.z, o.z)) <= s.half.z + slack);
    return select(inside, t, kInfinity);
}

static Float8 hitCylinder(const Shape &s, const Vec3x8 &o, const Vec3x8 &d) {
    // In the plane across the axis, find the ray's point nearest to the axis, then half the chord
    Float8 a = fmadd(d.x, d.x, d.z * d.z);
    Int8 parallel = a < 1e-12f;
    Float8 inverse = 1.f / select(parallel, 1.f, a);
    Float8 middle = -fmadd(o.x, d.x, o.z * d.z) * inverse;
    middle = select(parallel, 0.f, middle);
    Float8 px = fmadd(middle, d.x, o.x), pz = fmadd(middle, d.z, o.z);
    Float8 discriminant = s.half.x * s.half.x - fmadd(px, px, pz * pz);
    Float8 half = select(parallel, kInfinity, sqrt(max(discriminant, 0.f) * inverse));
    Float8 t = nearest(overlap({middle - half, middle + half}, slab(o.y, d.y, s.half.y)));
    return select(discriminant >= 0.f, t, kInfinity);
}

Float8 distance(const Shape &s, const Ray8 &ray, Flat flat) {
    if (s.isBall()) return hitSphere(s, ray);
    Vec3x8 toOrigin = ray.o - s.centre;
    Vec3x8 o = s.aligned ? toOrigin : s.frame * toOrigin, d = s.aligned ? ray.d : s.frame * ray.d;
    switch (s.kind) {
    case ShapeKind::Plane:
        return hitPlane(o.y, d.y);
    case ShapeKind::Box: {
        Interval inside = overlap(slab(o.x, d.x, s.half.x), slab(o.y, d.y, s.half.y));
        return nearest(overlap(inside, slab(o.z, d.z, s.half.z)));
    }
    case ShapeKind::Cylinder:
        return hitCylinder(s, o, d);
    case ShapeKind::Rect:
        return flat == Flat::Whole ? hitPlane(o.y, d.y) : hitRect(s, o, d, flat == Flat::BothSides);
    case ShapeKind::Sphere:
    case ShapeKind::Count:
        break;
    }
    __builtin_unreachable();
}

Surface8 surfaceAt(const Shape &s, const Ray8 &ray, Float8 t) {
    t = min(t, kFar);
    Vec3x8 p = fmadd(ray.d, t, ray.o);
    Vec3x8 fromCentre = p - s.centre;
    if (s.isBall()) {
        Vec3x8 n = normalize(fromCentre);
        return {n * broadcast(s.half.x) + s.centre, n, Int8{}};
    }
    Vec3x8 q = s.frame * fromCentre, n = {};
    Int8 face = {};
    switch (s.kind) {
    case ShapeKind::Box: {
        // The face is the one whose coordinate is nearest to its limit
        Vec3x8 over = {abs(q.x) - s.half.x, abs(q.y) - s.half.y, abs(q.z) - s.half.z};
        Int8 isX = (over.x >= over.y) & (over.x >= over.z);
        Int8 isY = ~isX & (over.y >= over.z), isZ = ~isX & ~isY;
        auto towards = [](Float8 x) { return select(x < 0.f, -1.f, 1.f); };
        n = {select(isX, towards(q.x), 0.f), select(isY, towards(q.y), 0.f), select(isZ, towards(q.z), 0.f)};
        q = {select(isX, n.x * s.half.x, q.x), select(isY, n.y * s.half.y, q.y),
             select(isZ, n.z * s.half.z, q.z)};
        face = (isY & 2) + (isZ & 4) + (((n.x + n.y + n.z) < 0.f) & 1);
        break;
    }
    case ShapeKind::Cylinder: {
        Float8 r = sqrt(fmadd(q.x, q.x, q.z * q.z));
        Int8 cap = abs(q.y) - s.half.y >= r - s.half.x;
        Float8 inverse = 1.f / max(r, 1e-20f), up = select(q.y < 0.f, -1.f, 1.f);
        n = {select(cap, 0.f, q.x * inverse), select(cap, up, 0.f), select(cap, 0.f, q.z * inverse)};
        q = {select(cap, q.x, n.x * s.half.x), select(cap, up * s.half.y, q.y),
             select(cap, q.z, n.z * s.half.x)};
        face = cap & (1 + ((up < 0.f) & 1));
        break;
    }
    case ShapeKind::Rect: {
        // Keep the point within the outline, so that secondary rays start in front of a wall that meets it
        float slack = 2 * slackOf(s), x = max(s.half.x - slack, 0.f), z = max(s.half.z - slack, 0.f);
        q.x = clamp(q.x, -x, x), q.z = clamp(q.z, -z, z);
        [[fallthrough]];
    }
    case ShapeKind::Plane:
        n.y = broadcast(1.f);
        q.y = Float8{};
        break;
    case ShapeKind::Sphere:
    case ShapeKind::Count:
        __builtin_unreachable();
    }
    return {transposeTimes(s.frame, q) + s.centre, transposeTimes(s.frame, n), face};
}

// Runs once for each shape and picture, so small code is better than fast code.
[[gnu::cold]] Bounds boundsOf(const Shape &s) {
    Vec3 r = s.half;
    switch (s.kind) {
    case ShapeKind::Box:
    case ShapeKind::Cylinder:
    case ShapeKind::Rect: {
        Vec3 u = s.frame.u * s.half.x, v = s.frame.v * s.half.y, w = s.frame.w * s.half.z;
        r = {abs(u.x) + abs(v.x) + abs(w.x), abs(u.y) + abs(v.y) + abs(w.y), abs(u.z) + abs(v.z) + abs(w.z)};
        break;
    }
    case ShapeKind::Sphere:
        break;
    case ShapeKind::Plane:
    case ShapeKind::Count:
        __builtin_unreachable();
    }
    return {s.centre - r, s.centre + r};
}

} // namespace odraz
