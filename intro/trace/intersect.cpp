#include "trace/intersect.h"

namespace odraz {

// The stretch of a ray inside a convex solid; empty where enter > leave.
struct Interval {
    Float8 enter, leave;
};

static Float8 nearest(Interval i) {
    Float8 t = select(i.enter > 0.f, i.enter, i.leave);
    return select((i.enter <= i.leave) & (t > 0.f) & (t < kFar), t, kInfinity);
}

// o + t d between -half and +half, in one coordinate. A direction of zero becomes a tiny one: no NaN.
static Interval slab(Float8 o, Float8 d, float half) {
    Int8 tiny = abs(d) < 1e-20f;
    Float8 inverse = 1.f / select(tiny, 1e-20f, d);
    Float8 a = (-half - o) * inverse, b = (half - o) * inverse;
    return {min(a, b), max(a, b)};
}

static Interval both(Interval a, Interval b) { return {max(a.enter, b.enter), min(a.leave, b.leave)}; }

static inline Float8 hitSphere(const Shape &s, const Ray8 &ray) {
    Vec3x8 f = ray.o - s.centre;
    float r = s.half.x;
    Float8 b = -dot(f, ray.d);
    Vec3x8 perpendicular = fmadd(ray.d, b, f);
    Float8 discriminant = r * r - dot(perpendicular, perpendicular);
    if (!any(discriminant >= 0.f)) return broadcast(kInfinity);
    // Take the root that adds magnitudes, get the other from their product
    Float8 c = dot(f, f) - r * r;
    Float8 root = sqrt(max(discriminant, 0.f));
    Float8 q = b + select(b < 0.f, -root, root);
    Float8 other = c / select(q == 0.f, 1e-30f, q);
    Float8 t0 = min(q, other), t1 = max(q, other);
    Float8 t = select(t0 > 0.f, t0, t1);
    return select((discriminant >= 0.f) & (t > 0.f) & (t < kFar), t, kInfinity);
}

static Float8 hitPlane(Float8 height, Float8 slope) {
    Float8 t = -height / slope;
    return select((t > 0.f) & (t < kFar), t, kInfinity);
}

// Within a rectangle widened by more than the rounding of the point: neighbours overlap, and no ray passes
// between them.
static Float8 hitRect(const Shape &s, Vec3x8 o, Vec3x8 d) {
    Float8 t = select(d.y < 0.f, hitPlane(o.y, d.y), kInfinity);
    Float8 finite = select(t < kInfinity, t, 0.f);
    float slack = (sumAbs(s.centre) + s.half.x + s.half.z) * 5e-7f;
    Int8 inside = (abs(fmadd(finite, d.x, o.x)) <= s.half.x + slack) &
                  (abs(fmadd(finite, d.z, o.z)) <= s.half.z + slack);
    return select(inside, t, kInfinity);
}

static Float8 hitCylinder(const Shape &s, Vec3x8 o, Vec3x8 d) {
    // About the axis, in the plane across it: nearest approach, then half the chord
    Float8 a = fmadd(d.x, d.x, d.z * d.z);
    Int8 parallel = a < 1e-12f;
    Float8 inverse = 1.f / select(parallel, 1.f, a);
    Float8 middle = -fmadd(o.x, d.x, o.z * d.z) * inverse;
    middle = select(parallel, 0.f, middle);
    Float8 px = fmadd(middle, d.x, o.x), pz = fmadd(middle, d.z, o.z);
    Float8 discriminant = s.half.x * s.half.x - fmadd(px, px, pz * pz);
    Float8 half = select(parallel, kInfinity, sqrt(max(discriminant, 0.f) * inverse));
    Float8 t = nearest(both({middle - half, middle + half}, slab(o.y, d.y, s.half.y)));
    return select(discriminant >= 0.f, t, kInfinity);
}

// Whether points of the polygon's plane lie within its outline: an odd number of edges to one side.
static Int8 inOutline(const Scene &scene, const Shape &s, Float8 x, Float8 z) {
    const float *v = scene.outline + 2 * s.firstVertex;
    Int8 odd = {};
    for (int i = 0, j = s.vertexCount - 1; i < s.vertexCount; j = i++) {
        float ax = v[2 * j], az = v[2 * j + 1], bx = v[2 * i], bz = v[2 * i + 1];
        if (az == bz) continue;
        Int8 spans = (z < az) ^ (z < bz);
        odd ^= spans & (x < fmadd((z - az) * (1.f / (bz - az)), bx - ax, broadcast(ax)));
    }
    return odd;
}

Float8 distance(const Scene &scene, const Shape &s, const Ray8 &ray, bool wholePlane) {
    if (s.kind == ShapeKind::Sphere) return hitSphere(s, ray);
    Vec3x8 toOrigin = ray.o - s.centre;
    Vec3x8 o = s.aligned ? toOrigin : s.frame * toOrigin, d = s.aligned ? ray.d : s.frame * ray.d;
    switch (s.kind) {
    case ShapeKind::Plane:
        return hitPlane(o.y, d.y);
    case ShapeKind::Box: {
        Interval inside = both(slab(o.x, d.x, s.half.x), slab(o.y, d.y, s.half.y));
        return nearest(both(inside, slab(o.z, d.z, s.half.z)));
    }
    case ShapeKind::Cylinder:
        return hitCylinder(s, o, d);
    case ShapeKind::Rect:
        return wholePlane ? hitPlane(o.y, d.y) : hitRect(s, o, d);
    default: {
        Float8 t = hitPlane(o.y, d.y);
        Int8 hit = t < kInfinity;
        if (wholePlane || !any(hit)) return t;
        Float8 finite = select(hit, t, 0.f);
        return select(hit & inOutline(scene, s, fmadd(finite, d.x, o.x), fmadd(finite, d.z, o.z)), t,
                      kInfinity);
    }
    }
}

Surface8 surfaceAt(const Shape &s, const Ray8 &ray, Float8 t) {
    t = min(t, kFar);
    Vec3x8 p = fmadd(ray.d, t, ray.o);
    Vec3x8 fromCentre = p - s.centre;
    if (s.kind == ShapeKind::Sphere) {
        Vec3x8 n = normalize(fromCentre);
        Vec3x8 onSphere = n * broadcast(s.half.x);
        return {onSphere + s.centre, n, s.frame * onSphere, Int8{}};
    }
    Vec3x8 q = s.frame * fromCentre;
    Vec3x8 n = {};
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
    default:
        n.y = broadcast(1.f);
        q.y = Float8{};
    }
    Vec3x8 world = transposeTimes(s.frame, q) + s.centre;
    return {world, transposeTimes(s.frame, n), s.kind == ShapeKind::Rect ? world : q, face};
}

Vec3x8 offsetOrigin(const Shape &s, const Surface8 &at, Float8 side) {
    // A few roundings of every magnitude that entered the point
    Float8 error = (sumAbs(at.p) + (sumAbs(s.centre) + maxComponent(s.half))) * 1e-6f + 1e-9f;
    return fmadd(at.n, error * side, at.p);
}

// Calls visit(shape) for every shape whose box an active ray enters before its limit, near boxes first if
// kSorted. visit may lower `limit` and clear lanes of `active`.
template <bool kSorted, class Visit>
static void traverse(const Scene &scene, const Ray8 &ray, Float8 &limit, Int8 &active, Visit &&visit) {
    for (int i = 0; i < scene.unboundedCount; ++i) visit(scene.unbounded[i]);
    if (!scene.nodeCount) return;
    auto invert = [](Float8 d) { return 1.f / select(abs(d) < 1e-20f, 1e-20f, d); };
    Vec3x8 inverse = {invert(ray.d.x), invert(ray.d.y), invert(ray.d.z)};
    // Box planes are met at plane / d - o / d. The quotients' rounding is what a box must be widened by; with
    // the three roundings behind them (Ize, "Robust BVH Ray Traversal", JCGT 2013) no ray slips between shape
    // and box
    Vec3x8 shift = ray.o * inverse;
    Float8 slack = max(abs(shift.x), max(abs(shift.y), abs(shift.z))) * 2.4e-7f;
    auto enters = [&](const Node &n) {
        auto meet = [](float plane, Float8 inverse, Float8 shift) {
            return (Float8)_mm256_fmsub_ps(broadcast(plane), inverse, shift);
        };
        Float8 ax = meet(n.lo.x, inverse.x, shift.x), bx = meet(n.hi.x, inverse.x, shift.x);
        Float8 ay = meet(n.lo.y, inverse.y, shift.y), by = meet(n.hi.y, inverse.y, shift.y);
        Float8 az = meet(n.lo.z, inverse.z, shift.z), bz = meet(n.hi.z, inverse.z, shift.z);
        Float8 enter = max(max(min(ax, bx), min(ay, by)), max(min(az, bz), 0.f));
        Float8 leave = min(min(max(ax, bx), max(ay, by)), max(az, bz));
        return select((enter <= fmadd(leave, 1.0000004f, slack)) & (enter < limit) & active, enter,
                      kInfinity);
    };
    auto nearestLane = [](Float8 x) {
        Float8 m = min(x, (Float8)_mm256_permute2f128_ps(x, x, 1));
        m = min(m, (Float8)_mm256_permute_ps(m, 0x4e));
        return min(m, (Float8)_mm256_permute_ps(m, 0xb1))[0];
    };

    // Of two boxes the one that begins farther away waits, and is looked at again if some ray still reaches
    // it
    struct Waiting {
        int node;
        float enter;
    } stack[32];
    int waiting = 0, node = 0;
    if (!any(enters(scene.nodes[0]) < kInfinity)) return;
    for (;;) {
        const Node &n = scene.nodes[node];
        if (n.count) {
            for (int i = 0; i < n.count; ++i) visit(scene.order[n.first + i]);
            if (!any(active)) return;
        } else {
            Float8 first = enters(scene.nodes[n.first]), second = enters(scene.nodes[n.first + 1]);
            bool inFirst = any(first < kInfinity), inSecond = any(second < kInfinity);
            if (inFirst && inSecond) {
                int swap = 0;
                float later = 0;
                if (kSorted) {
                    float a = nearestLane(first), b = nearestLane(second);
                    swap = b < a;
                    later = swap ? a : b;
                }
                stack[waiting++] = {n.first + 1 - swap, later};
                node = n.first + swap;
                continue;
            }
            if (inFirst || inSecond) {
                node = n.first + inSecond;
                continue;
            }
        }
        do {
            if (!waiting) return;
            node = stack[--waiting].node;
        } while (kSorted && !any((stack[waiting].enter < limit) & active));
    }
}

// Most shapes are balls: their test is worth having in the loop.
static inline Float8 distanceTo(const Scene &scene, const Shape &s, const Ray8 &ray) {
    return s.kind == ShapeKind::Sphere ? hitSphere(s, ray) : distance(scene, s, ray);
}

Hit8 intersect(const Scene &scene, const Ray8 &ray, Int8 active) {
    Hit8 hit = {broadcast(kInfinity), broadcast(-1)};
    traverse<true>(scene, ray, hit.t, active, [&](int shape) {
        Float8 t = distanceTo(scene, scene.shapes[shape], ray);
        Int8 nearer = t < hit.t;
        hit.t = select(nearer, t, hit.t);
        hit.shape = select(nearer, broadcast(shape), hit.shape);
    });
    return hit;
}

Rgb8 transmittance(const Scene &scene, const Ray8 &ray, Float8 tMax, Int8 active, int &blocker) {
    // What stood in the way of the rays before may well stand in the way of these
    if (blocker >= 0) {
        active &= ~(distanceTo(scene, scene.shapes[blocker], ray) < tMax);
        if (!any(active)) return broadcast(Rgb{});
    }
    Rgb8 share = select(active, broadcast(Rgb{1, 1, 1}), broadcast(Rgb{}));
    traverse<false>(scene, ray, tMax, active, [&](int index) {
        const Shape &shape = scene.shapes[index];
        const Material &m = scene.materials[shape.material];
        if (maxComponent(m.emit) > 0) return; // a lamp's body does not shade its own light
        Int8 hit = active & (distanceTo(scene, shape, ray) < tMax);
        if (!any(hit)) return;
        Rgb through = m.ior > 0 ? m.tint : Rgb{0, 0, 0};
        share = select(hit, share * through, share);
        if (m.ior == 0) {
            active &= ~hit;
            blocker = index;
        }
    });
    return share;
}

} // namespace odraz
