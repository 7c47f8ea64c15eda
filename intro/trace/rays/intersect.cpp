#include "trace/rays/intersect.h"

#include "trace/rays/stream.h"

#include <stddef.h>

namespace odraz {

namespace {

// Rays prepared for slab tests. A ray meets a box plane at t = plane / d - o / d. Boxes are widened by the
// rounding errors of these quotients and of the three operations that follow (Ize, "Robust BVH Ray
// Traversal", JCGT 2013), so that no ray misses the box of a shape that it hits.
struct Slabs {
    Vec3x8 inverse, shift;
    Float8 slack;

    // The slabs of ray k, in every lane.
    Slabs ofLane(int k) const {
        return {{broadcast(inverse.x[k]), broadcast(inverse.y[k]), broadcast(inverse.z[k])},
                {broadcast(shift.x[k]), broadcast(shift.y[k]), broadcast(shift.z[k])},
                broadcast(slack[k])};
    }
    [[gnu::noinline]] static Slabs from(const Ray8 &ray) {
        Vec3x8 inverse, shift;
        auto invert = [](Float8 d) { return 1.f / select(abs(d) < 1e-20f, 1e-20f, d); };
        inverse = {invert(ray.d.x), invert(ray.d.y), invert(ray.d.z)};
        shift = ray.o * inverse;
        return {inverse, shift, max(abs(shift.x), max(abs(shift.y), abs(shift.z))) * 2.4e-7f};
    }
    // Returns which rays meet boxes before the limit. `enter` gets the distances at which they enter.
    Int8 meet(Vec3x8 lo, Vec3x8 hi, Float8 limit, Float8 &enter) const {
        auto meet = [](Float8 plane, Float8 inverse, Float8 shift) {
            return (Float8)_mm256_fmsub_ps(plane, inverse, shift);
        };
        Float8 ax = meet(lo.x, inverse.x, shift.x), bx = meet(hi.x, inverse.x, shift.x);
        Float8 ay = meet(lo.y, inverse.y, shift.y), by = meet(hi.y, inverse.y, shift.y);
        Float8 az = meet(lo.z, inverse.z, shift.z), bz = meet(hi.z, inverse.z, shift.z);
        enter = max(max(min(ax, bx), min(ay, by)), max(min(az, bz), 0.f));
        Float8 leave = min(min(max(ax, bx), max(ay, by)), max(az, bz));
        return (enter <= fmadd(leave, 1.0000004f, slack)) & (enter <= limit);
    }
};

// Bounds of the active rays of a packet, by which one test culls eight boxes for eight rays. Along an axis on
// which all rays point to the same side, the intervals of their origins and inverse directions bound where
// they enter and leave boxes. Other axes bound nothing.
class Packet {
public:
    [[gnu::noinline]] Packet(const Ray8 &ray, const Slabs &slabs, Int8 active) {
        int lanes = laneBits(active);
        // Replace inactive rays by the first active one
        Int8 order = select(active, kLanes, broadcast(__builtin_ctz((unsigned)lanes)));
        constexpr int kToHigh = (int)(offsetof(Node, hi) / sizeof(float));
        const Float8 *from = &ray.o.x, *slope = &slabs.inverse.x; // x, y, z
        for (int k = 0; k < 3; ++k) {
            int backward = laneBits((Int8)slope[k]) & lanes;
            if (backward && backward != lanes) continue;
            Float8 inverse = permute(slope[k], order);
            Int8 sign = (Int8)inverse & (int)0x80000000;
            Range origins(flip(permute(from[k], order), sign)), slopes(flip(inverse, sign));
            int low = k * 8, high = low + kToHigh;
            axes[count++] = {low,
                             backward ? high : low,
                             backward ? low : high,
                             sign,
                             flip(origins.most, sign),
                             flip(slopes.least, sign),
                             flip(origins.least, sign),
                             flip(slopes.most, sign)};
        }
        slack = Range(permute(slabs.slack, order)).most * 2.f;
    }
    // Returns a bit for each box or ball of a node that some ray may enter before the limit.
    [[gnu::noinline]] int mayEnter(const Node &n, Float8 limit) const {
        const float *numbers = n.lo[0];
        Float8 enter = {}, leave = limit;
        auto meet = [&](const Axis &a, Float8 near, Float8 far) {
            enter = max(enter, (near - a.nearOrigin) * a.nearSlope);
            leave = min(leave, (far - a.farOrigin) * a.farSlope);
        };
        if (n.balls) {
            for (const Axis *a = axes; a < axes + count; ++a) {
                Float8 centre = load(numbers + a->centre), radius = flip(load(n.radius), a->sign);
                meet(*a, centre - radius, centre + radius);
            }
        } else {
            for (const Axis *a = axes; a < axes + count; ++a)
                meet(*a, load(numbers + a->near), load(numbers + a->far));
        }
        // Allow for rounding errors, here and in the tests of single rays
        return laneBits((enter <= fmadd(leave, 1.000002f, slack)) & (kLanes < n.count));
    }

private:
    // The least and the greatest of eight numbers, in every lane.
    struct Range {
        Float8 least, most;

        explicit Range(Float8 v) {
            Float8 m =
                min((Float8)_mm256_permute2f128_ps(v, -v, 0x20), (Float8)_mm256_permute2f128_ps(v, -v, 0x31));
            m = min(m, (Float8)_mm256_permute_ps(m, 0x4e));
            m = min(m, (Float8)_mm256_permute_ps(m, 0xb1));
            least = (Float8)_mm256_permute2f128_ps(m, m, 0);
            most = -(Float8)_mm256_permute2f128_ps(m, m, 0x11);
        }
    };
    // Negates v where the rays point to the negative side.
    static Float8 flip(Float8 v, Int8 sign) { return (Float8)((Int8)v ^ sign); }
    struct Axis {
        // Offsets in a node: centres of balls; the planes at which rays enter and leave boxes
        int centre, near, far;
        Int8 sign; // the side to which the rays point
        // The origin and slope with the earliest possible entry, and those with the latest possible exit
        Float8 nearOrigin, nearSlope, farOrigin, farSlope;
    } axes[3];
    int count = 0;
    Float8 slack;
};

// Nodes of the tree that are still to be visited, the nearest last.
struct Stack {
    struct Entry {
        int node;
        float enter;
    } entries[7 * kTreeDepth + 8];
    int count = 0;

    // Pushes a node and keeps the entries from index `base` on sorted.
    void push(int base, int node, float enter) {
        int i = count++;
        for (; i > base && entries[i - 1].enter < enter; --i) entries[i] = entries[i - 1];
        entries[i] = {node, enter};
    }
};

// Calls meet(with, shape, t) for every unbounded shape, and for every bounded one that an active ray hits
// before its limit, near nodes first for Flat::Seen. `t` holds the distances to the shape. meet may lower
// `limit` and clear lanes of `active`. (A function pointer, so that this large loop is compiled once.)
[[gnu::noinline, gnu::noclone]] void traverse(const Scene &scene, const Ray8 &ray, Flat flat, Float8 &limit,
                                              Int8 &active,
                                              void (*meet)(const void *with, int shape, Float8 t),
                                              const void *with) {
    for (int i = 0; i < scene.unboundedCount; ++i)
        meet(with, scene.unbounded[i], distance(scene.shapes[scene.unbounded[i]], ray, flat));
    if (!scene.nodeCount || !any(active)) return;
    const bool sorted = flat == Flat::Seen;
    Slabs slabs = Slabs::from(ray);
    const Packet packet(ray, slabs, active);
    Float8 reach = select(active, min(limit, kFar), -1.f), farthest = broadcast(-least(-reach));
    Stack stack;
    stack.push(0, 0, 0);
    while (stack.count) {
        Stack::Entry next = stack.entries[--stack.count];
        if (next.enter > farthest[0]) continue;
        const Node &n = scene.nodes[next.node];
        int base = stack.count;
        for (int boxes = packet.mayEnter(n, farthest); boxes; boxes &= boxes - 1) {
            int i = __builtin_ctz((unsigned)boxes);
            Vec3 lo = {n.lo[0][i], n.lo[1][i], n.lo[2][i]};
            Float8 t;
            if (n.balls) {
                t = hitBall(ray.o - lo, n.radius[i], ray.d);
            } else {
                Vec3 hi = {n.hi[0][i], n.hi[1][i], n.hi[2][i]};
                Float8 enter;
                Int8 entered = slabs.meet(broadcast(lo), broadcast(hi), reach, enter);
                if (!any(entered)) continue;
                if (n.child[i] >= 0) {
                    stack.push(base, n.child[i], sorted ? least(select(entered, enter, kInfinity)) : 0);
                    continue;
                }
                t = distance(scene.shapes[~n.child[i]], ray, flat);
            }
            if (!any(t <= reach)) continue;
            meet(with, ~n.child[i], t);
            reach = select(active, min(limit, kFar), -1.f);
            farthest = broadcast(-least(-reach));
        }
    }
}

// Finds the nearest hit of a single ray, which is in every lane. Tests eight boxes or balls at once.
void intersectOne(const Scene &scene, const Ray8 &ray, const Slabs &slabs, float &t, int &shape) {
    auto take = [&](int index, float hit) {
        if (hit > t || (hit == t && index > shape)) return;
        t = hit;
        shape = index;
    };
    Stack stack;
    stack.push(0, 0, 0);
    while (stack.count) {
        Stack::Entry next = stack.entries[--stack.count];
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
        Float8 enter;
        Int8 entered = slabs.meet(lo, load(n.hi, 0), broadcast(t), enter);
        int base = stack.count;
        for (int lanes = laneBits(entered & (kLanes < n.count)); lanes; lanes &= lanes - 1) {
            int i = __builtin_ctz((unsigned)lanes);
            if (n.child[i] >= 0)
                stack.push(base, n.child[i], enter[i]);
            else
                take(~n.child[i], distance(scene.shapes[~n.child[i]], ray)[0]);
        }
    }
}

// Whether the tree is so large, and the rays diverge so much, that it is faster to trace each ray alone.
bool diverge(const Scene &scene, const Ray8 &ray, Int8 active) {
    if (scene.nodeCount < 128) return false;
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
            updateNearest(hit, distance(scene.shapes[scene.unbounded[i]], ray), scene.unbounded[i]);
        float t[8];
        int shape[8];
        store(t, hit.t), store(shape, hit.shape);
        Slabs slabs = Slabs::from(ray);
        for (int lanes = laneBits(active); lanes; lanes &= lanes - 1) {
            int k = __builtin_ctz((unsigned)lanes);
            Vec3 o = {ray.o.x[k], ray.o.y[k], ray.o.z[k]}, d = {ray.d.x[k], ray.d.y[k], ray.d.z[k]};
            intersectOne(scene, {broadcast(o), broadcast(d)}, slabs.ofLane(k), t[k], shape[k]);
        }
        return {load(t), loadInts(shape)};
    }
    if (scene.shapeCount <= 12) {
        for (int i = 0; i < scene.shapeCount; ++i) {
            Float8 t = distance(scene.shapes[i], ray);
            if (any(t < hit.t)) updateNearest(hit, t, i); // at equal distances the first shape stays
        }
        return hit;
    }
    traverse(
        scene, ray, Flat::Seen, hit.t, active,
        [](const void *hit, int shape, Float8 t) { updateNearest(*(Hit8 *)hit, t, shape); }, &hit);
    return hit;
}

[[gnu::noinline]] void dim(const Scene &scene, const Shape &shape, Int8 hit, Rgb8 &share, Int8 &active) {
    const Material &m = scene.materials[shape.material];
    if (maxComponent(m.emit) > 0 && m.diffuse == 0) return; // a lamp does not shade its own light
    Rgb through = m.ior > 0 ? m.tint : Rgb{0, 0, 0};
    share = select(hit, share * through, share);
    if (m.ior == 0) active &= ~hit;
}

Rgb8 transmittance(const Scene &scene, const Ray8 &ray, Float8 tMax, Int8 active, Int8 ignored,
                   bool noBalls) {
    Rgb8 share = select(active, broadcast(Rgb{1, 1, 1}), broadcast(Rgb{}));
    auto meet = [&](int index, Float8 t) {
        if (noBalls && scene.shapes[index].isBall()) return;
        Int8 hit = active & (t < tMax) & (ignored != index);
        if (any(hit)) dim(scene, scene.shapes[index], hit, share, active);
    };
    traverse(
        scene, ray, Flat::BothSides, tMax, active,
        [](const void *f, int shape, Float8 t) { (*(decltype(meet) *)f)(shape, t); }, &meet);
    return share;
}

} // namespace odraz
