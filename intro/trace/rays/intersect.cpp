#include "trace/rays/intersect.h"

namespace odraz {

namespace {

// Rays prepared for slab tests. A ray meets a box plane at plane / d - o / d. Boxes are widened by the
// rounding errors of these quotients and of the three operations that follow (Ize, "Robust BVH Ray
// Traversal", JCGT 2013), so that no ray misses the box of a shape that it hits.
struct Slabs {
    Vec3x8 inverse, shift;
    Float8 slack;

    // Those of ray k, in every lane.
    Slabs of(int k) const {
        return {{broadcast(inverse.x[k]), broadcast(inverse.y[k]), broadcast(inverse.z[k])},
                {broadcast(shift.x[k]), broadcast(shift.y[k]), broadcast(shift.z[k])},
                broadcast(slack[k])};
    }
    static Slabs from(const Ray8 &ray) {
        Vec3x8 inverse, shift;
        auto invert = [](Float8 d) { return 1.f / select(abs(d) < 1e-20f, 1e-20f, d); };
        inverse = {invert(ray.d.x), invert(ray.d.y), invert(ray.d.z)};
        shift = ray.o * inverse;
        return {inverse, shift, max(abs(shift.x), max(abs(shift.y), abs(shift.z))) * 2.4e-7f};
    }
    // The distances at which the rays enter boxes; kInfinity if that is not before the limit.
    Float8 enter(Vec3x8 lo, Vec3x8 hi, Float8 limit) const {
        auto meet = [](Float8 plane, Float8 inverse, Float8 shift) {
            return (Float8)_mm256_fmsub_ps(plane, inverse, shift);
        };
        Float8 ax = meet(lo.x, inverse.x, shift.x), bx = meet(hi.x, inverse.x, shift.x);
        Float8 ay = meet(lo.y, inverse.y, shift.y), by = meet(hi.y, inverse.y, shift.y);
        Float8 az = meet(lo.z, inverse.z, shift.z), bz = meet(hi.z, inverse.z, shift.z);
        Float8 enter = max(max(min(ax, bx), min(ay, by)), max(min(az, bz), 0.f));
        Float8 leave = min(min(max(ax, bx), max(ay, by)), max(az, bz));
        return select((enter <= fmadd(leave, 1.0000004f, slack)) & (enter <= limit), enter, kInfinity);
    }
};

// Nodes of the tree that are still to be visited, the nearest last.
struct Stack {
    struct Waiting {
        int node;
        float enter;
    } waiting[7 * kTreeDepth + 8];
    int count = 0;

    // Pushes a node above the first `base` ones, in sorted order.
    void push(int base, int node, float enter) {
        int i = count++;
        for (; i > base && waiting[i - 1].enter < enter; --i) waiting[i] = waiting[i - 1];
        waiting[i] = {node, enter};
    }
};

// Calls meet(shape, t) for every unbounded shape, and for every bounded one that an active ray hits before
// its limit, near nodes first if kSorted. `t` holds the distances to the shape. meet may lower `limit` and
// clear lanes of `active`.
template <bool kSorted, class Meet>
void traverse(const Scene &scene, const Ray8 &ray, Flat flat, Float8 &limit, Int8 &active, Meet &&meet) {
    for (int i = 0; i < scene.unboundedCount; ++i)
        meet(scene.unbounded[i], distance(scene.shapes[scene.unbounded[i]], ray, flat));
    if (!scene.nodeCount || !any(active)) return;
    Slabs slabs = Slabs::from(ray);
    Stack stack;
    stack.push(0, 0, 0);
    while (stack.count) {
        Stack::Waiting next = stack.waiting[--stack.count];
        Float8 reach = select(active, min(limit, kFar), -1.f);
        if (!any(reach >= next.enter)) continue;
        const Node &n = scene.nodes[next.node];
        int base = stack.count;
        for (int i = 0; i < n.count; ++i) {
            Vec3 lo = {n.lo[0][i], n.lo[1][i], n.lo[2][i]};
            Float8 t;
            if (n.balls) {
                t = hitBall(ray.o - lo, n.radius[i], ray.d);
            } else {
                Vec3 hi = {n.hi[0][i], n.hi[1][i], n.hi[2][i]};
                Float8 enter = slabs.enter(broadcast(lo), broadcast(hi), reach);
                if (!any(enter < kInfinity)) continue;
                if (n.child[i] >= 0) {
                    stack.push(base, n.child[i], kSorted ? least(enter) : 0);
                    continue;
                }
                t = distance(scene.shapes[~n.child[i]], ray, flat);
            }
            if (!any(t <= reach)) continue;
            meet(~n.child[i], t);
            reach = select(active, min(limit, kFar), -1.f);
        }
        if (!any(active)) return;
    }
}

// The nearest hit of a single ray, which stands in every lane. Tests eight boxes or balls at once.
void intersectOne(const Scene &scene, const Ray8 &ray, const Slabs &slabs, float &t, int &shape) {
    auto take = [&](int index, float hit) {
        if (hit > t || (hit == t && index > shape)) return;
        t = hit;
        shape = index;
    };
    Stack stack;
    stack.push(0, 0, 0);
    while (stack.count) {
        Stack::Waiting next = stack.waiting[--stack.count];
        if (next.enter > t) continue;
        const Node &n = scene.nodes[next.node];
        Vec3x8 lo = load(n.lo, 0);
        if (n.balls) {
            Vec3x8 f = ray.o - lo;
            Float8 radius = load(n.radius);
            Float8 hit = hitBall(f, radius, ray.d);
            for (int lanes = laneBits((hit <= t) & (hit < kInfinity)); lanes; lanes &= lanes - 1) {
                int i = __builtin_ctz((unsigned)lanes);
                take(~n.child[i], hit[i]);
            }
            continue;
        }
        Float8 enter = slabs.enter(lo, load(n.hi, 0), broadcast(t));
        int base = stack.count;
        for (int lanes = laneBits((enter < kInfinity) & (kLanes < n.count)); lanes; lanes &= lanes - 1) {
            int i = __builtin_ctz((unsigned)lanes);
            if (n.child[i] >= 0)
                stack.push(base, n.child[i], enter[i]);
            else
                take(~n.child[i], distanceTo(scene.shapes[~n.child[i]], ray)[0]);
        }
    }
}

// Whether the tree is so large, and the rays so far apart, that it is faster to trace each ray alone.
bool diverge(const Scene &scene, const Ray8 &ray, Int8 active) {
    if (scene.nodeCount < 12) return false;
    int first = __builtin_ctz((unsigned)laneBits(active) | 256);
    if (first == 8) return false;
    Vec3 d = {ray.d.x[first], ray.d.y[first], ray.d.z[first]};
    return any((dot(d, ray.d) < -0.2f) & active);
}

} // namespace

Hit8 intersect(const Scene &scene, const Ray8 &ray, Int8 active) {
    Hit8 hit = {broadcast(kInfinity), broadcast(-1)};
    if (diverge(scene, ray, active)) {
        for (int i = 0; i < scene.unboundedCount; ++i)
            takeNearer(hit, distance(scene.shapes[scene.unbounded[i]], ray), scene.unbounded[i]);
        float t[8];
        int shape[8];
        store(t, hit.t), store(shape, hit.shape);
        Slabs slabs = Slabs::from(ray);
        for (int lanes = laneBits(active); lanes; lanes &= lanes - 1) {
            int k = __builtin_ctz((unsigned)lanes);
            Vec3 o = {ray.o.x[k], ray.o.y[k], ray.o.z[k]}, d = {ray.d.x[k], ray.d.y[k], ray.d.z[k]};
            intersectOne(scene, {broadcast(o), broadcast(d)}, slabs.of(k), t[k], shape[k]);
        }
        return {load(t), loadInts(shape)};
    }
    if (scene.shapeCount <= 12) {
        Float8 nearest = hit.t;
        Int8 which = hit.shape;
        for (int i = 0; i < scene.shapeCount; ++i) {
            Float8 t = distanceTo(scene.shapes[i], ray);
            Int8 nearer = t < nearest; // at equal distances the first one stays
            if (!any(nearer)) continue;
            nearest = min(t, nearest);
            which = select(nearer, broadcast(i), which);
        }
        return {nearest, which};
    }
    traverse<true>(scene, ray, Flat::Seen, hit.t, active,
                   [&](int shape, Float8 t) { takeNearer(hit, t, shape); });
    return hit;
}

Rgb8 transmittance(const Scene &scene, const Ray8 &ray, Float8 tMax, Int8 active, Int8 own, bool noBalls) {
    Rgb8 share = select(active, broadcast(Rgb{1, 1, 1}), broadcast(Rgb{}));
    traverse<false>(scene, ray, Flat::BothSides, tMax, active, [&](int index, Float8 t) {
        if (noBalls && scene.shapes[index].isBall()) return;
        Int8 hit = active & (t < tMax) & (own != index);
        if (any(hit)) dim(scene, scene.shapes[index], hit, share, active);
    });
    return share;
}

} // namespace odraz
