#include "tools/radiosity/rays/ray_tree.h"
#include "trace/scene/split.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odraz::radiosity {

struct RayTree::Ray {
    Vec3x8 o, inverse;
    int kx, ky, kz; // axes; along kz the direction has its largest component
    Float8 sx, sy, sz;

    Ray(const Vec3 &origin, const Vec3 &direction) : o(broadcast(origin)) {
        auto invert = [](float x) { return broadcast(1 / (std::fabs(x) < 1e-20f ? 1e-20f : x)); };
        inverse = {invert(direction.x), invert(direction.y), invert(direction.z)};
        const float d[3] = {direction.x, direction.y, direction.z};
        kz = 0;
        for (int k = 1; k < 3; ++k)
            if (std::fabs(d[k]) > std::fabs(d[kz])) kz = k;
        kx = (kz + 1) % 3, ky = (kz + 2) % 3;
        if (d[kz] < 0) std::swap(kx, ky); // keeps the handedness
        sx = broadcast(d[kx] / d[kz]), sy = broadcast(d[ky] / d[kz]), sz = broadcast(1 / d[kz]);
    }
    // The distances at which the ray enters eight boxes; kInfinity if beyond the limit. Exit distances are
    // increased by the possible rounding error (Ize, "Robust BVH Ray Traversal", JCGT 2013).
    Float8 enter(const Node &n, float limit) const {
        Float8 ax = (load(n.lo[0]) - o.x) * inverse.x, bx = (load(n.hi[0]) - o.x) * inverse.x;
        Float8 ay = (load(n.lo[1]) - o.y) * inverse.y, by = (load(n.hi[1]) - o.y) * inverse.y;
        Float8 az = (load(n.lo[2]) - o.z) * inverse.z, bz = (load(n.hi[2]) - o.z) * inverse.z;
        Float8 in = max(max(min(ax, bx), min(ay, by)), max(min(az, bz), 0.f));
        Float8 out = min(min(max(ax, bx), max(ay, by)), max(az, bz)) * 1.0000005f;
        return select((in <= out) & (in <= broadcast(limit)), in, kInfinity);
    }
    // The distances to a leaf's triangles; kInfinity for a miss. Sets `back` where a back is hit. Corners are
    // sheared so that the ray becomes an axis. Both triangles at an edge then compute the same values for it,
    // so the ray cannot pass between them by rounding.
    Float8 intersect(const Leaf &l, Int8 &back) const {
        struct Sheared {
            Float8 x, y, z;
        };
        const Float8 from[3] = {o.x, o.y, o.z};
        auto corner = [&](int k) {
            Float8 z = load(l.corner[k][kz]) - from[kz];
            return Sheared{fmadd(-sx, z, load(l.corner[k][kx]) - from[kx]),
                           fmadd(-sy, z, load(l.corner[k][ky]) - from[ky]), z * sz};
        };
        // a b - c d, nearly exact (Kahan)
        auto difference = [](Float8 a, Float8 b, Float8 c, Float8 d) {
            Float8 cd = c * d;
            return (Float8)_mm256_fmsub_ps(a, b, cd) + (Float8)_mm256_fnmadd_ps(c, d, cd);
        };
        Sheared a = corner(0), b = corner(1), c = corner(2);
        Float8 u = difference(c.x, b.y, c.y, b.x), v = difference(a.x, c.y, a.y, c.x),
               w = difference(b.x, a.y, b.y, a.x);
        Float8 least = min(u, min(v, w)), most = max(u, max(v, w)), sum = u + v + w;
        Float8 t = fmadd(u, a.z, fmadd(v, b.z, w * c.z)) / sum;
        back = sum < 0.f;
        Int8 hit = ((least >= 0.f) | (most <= 0.f)) & (sum != 0.f) & (t > 0.f);
        return select(hit, t, kInfinity);
    }
};

namespace {

// A node to visit; the nearest is on top of the stack.
struct StackEntry {
    int node;
    float enter;
};
constexpr int kMaxStack = 512;
// Factor for distances to backs, so that the front is hit if both are in one plane
constexpr float kBehind = 1.0001f;
constexpr float kParallel = 0.9999f; // least cosine between parallel normals
constexpr float kSame = 1.000001f;   // hits whose distances differ by less than this factor count as one

} // namespace

template <bool kFronts> RayHit RayTree::find(const Vec3 &origin, const Vec3 &direction, bool repeated) const {
    Ray ray(origin, direction);
    RayHit hit;
    float limit = kInfinity, reach = kInfinity; // distance of the hit; the same plus a tolerance
    float second = kInfinity;                   // distance of the next front
    int leaf = 0, lane = 0;                     // position of the hit triangle
    StackEntry stack[kMaxStack];
    int waiting = 0;
    stack[waiting++] = {0, 0};
    while (waiting) {
        StackEntry next = stack[--waiting];
        if (next.enter > limit) continue;
        if (next.node < 0) {
            const Leaf &l = leaves[(size_t)~next.node];
            Int8 back;
            Float8 t = ray.intersect(l, back),
                   distance = select(back, kFronts ? broadcast(kInfinity) : t * kBehind, t);
            for (int lanes = laneBits((distance <= broadcast(reach)) & (distance < kInfinity)); lanes;
                 lanes &= lanes - 1) {
                int i = __builtin_ctz((unsigned)lanes);
                if (l.number[i] < 0) continue;
                // At equal distances take the first triangle, so that the result does not depend on the tree
                bool nearer = distance[i] < limit || (distance[i] == limit && l.number[i] < hit.triangle);
                if (nearer ? !hit.back && hit.triangle >= 0 : !back[i])
                    second = std::min(second, nearer ? limit : distance[i]);
                if (!nearer) continue;
                limit = distance[i], reach = limit * kSame + wider;
                hit = {t[i], l.number[i], back[i] != 0}, leaf = next.node, lane = i;
            }
            continue;
        }
        const Node &n = nodes[(size_t)next.node];
        Float8 enter = ray.enter(n, limit);
        int base = waiting;
        for (int lanes = laneBits(enter < kInfinity); lanes; lanes &= lanes - 1) {
            int i = __builtin_ctz((unsigned)lanes), at = waiting++;
            float e = enter[i];
            for (; at > base && stack[at - 1].enter < e; --at) stack[at] = stack[at - 1];
            stack[at] = {n.child[i], e};
        }
    }
    // If two fronts are hit at one distance, as at a shared edge, rounding decides which is first: repeat
    // with a ray that hits this triangle farther inside
    if (hit.triangle < 0 || hit.back || second > reach || repeated) return hit;
    const Leaf &l = leaves[(size_t)~leaf];
    Vec3 inward =
        (l.point(0, lane) + l.point(1, lane) + l.point(2, lane)) * (1 / 3.f) - (origin + direction * hit.t);
    float offset = std::min(4 * wider / hit.t + 1e-6f, 0.01f) / std::max(length(inward), 1e-20f);
    return find<kFronts>(origin, direction + inward * offset, true);
}

RayHit RayTree::nearest(const Vec3 &origin, const Vec3 &direction) const {
    return find<false>(origin, direction, false);
}
RayHit RayTree::nearestFront(const Vec3 &origin, const Vec3 &direction) const {
    return find<true>(origin, direction, false);
}

bool RayTree::blocked(const Vec3 &origin, const Vec3 &direction, float end, const Vec3 *n) const {
    Ray ray(origin, direction);
    const float before = n ? end * 0.9999f : end;
    int stack[kMaxStack], waiting = 0;
    stack[waiting++] = 0;
    while (waiting) {
        int next = stack[--waiting];
        if (next < 0) {
            Int8 back;
            const Leaf &l = leaves[(size_t)~next];
            Float8 t = ray.intersect(l, back);
            if (any(t < broadcast(before))) return true;
            for (int lanes = n ? laneBits(t < broadcast(end)) : 0; lanes; lanes &= lanes - 1) {
                int i = __builtin_ctz((unsigned)lanes);
                Vec3 across = cross(l.point(1, i) - l.point(0, i), l.point(2, i) - l.point(0, i));
                if (std::fabs(dot(across, *n)) < kParallel * length(across)) return true;
            }
            continue;
        }
        const Node &n = nodes[(size_t)next];
        for (int lanes = laneBits(ray.enter(n, end) < kInfinity); lanes; lanes &= lanes - 1)
            stack[waiting++] = n.child[__builtin_ctz((unsigned)lanes)];
    }
    return false;
}

// --- Building ---

struct RayTree::Builder {
    RayTree &tree;
    const std::vector<Corners> &triangles;
    struct Item {
        Bounds box;
        int number;
    };
    std::vector<Item> items;
    // Rounding may let a ray hit a triangle but miss its box, so boxes grow by this share of the whole tree's
    // box
    static constexpr float kWider = 2e-7f;

    struct Group {
        int first, count;
        Bounds box;
    };
    static constexpr int kLeaf = 8;
    static constexpr int kSplit = 40; // down to this depth split by surface area, below it by count

    Bounds boxOf(int first, int count) const {
        Bounds b = kNoBounds;
        for (int i = first; i < first + count; ++i) include(b, items[(size_t)i].box);
        return b;
    }

    int split(const Group &g, int deep) {
        return splitGroup(
            g.first, g.count, deep > kSplit, [&](int i) -> const Bounds & { return items[(size_t)i].box; },
            [&](int i, int k) { std::swap(items[(size_t)i], items[(size_t)k]); });
    }

    int leaf(const Group &g) {
        Leaf l = {};
        for (int k = 0; k < kLeaf; ++k) {
            l.number[k] = k < g.count ? items[(size_t)(g.first + k)].number : -1;
            if (k >= g.count) continue;
            const Corners &c = triangles[(size_t)l.number[k]];
            for (size_t i = 0; i < 3; ++i)
                l.corner[i][0][k] = c[i].x, l.corner[i][1][k] = c[i].y, l.corner[i][2][k] = c[i].z;
        }
        tree.leaves.push_back(l);
        return ~(int)(tree.leaves.size() - 1);
    }

    // Makes a node of a group: splits the part with the largest surface until there are eight parts.
    int build(const Group &all, int deep) {
        auto index = (int)tree.nodes.size();
        tree.nodes.emplace_back();
        Group parts[8] = {all};
        int count = 1;
        while (count < 8) {
            int largest = -1;
            float area = -1;
            for (int i = 0; i < count; ++i)
                if (float a = halfArea(parts[i].box); parts[i].count > kLeaf && a > area)
                    largest = i, area = a;
            if (largest < 0) break;
            Group &g = parts[largest];
            int front = split(g, deep), rest = g.first + front;
            parts[count++] = {rest, g.count - front, boxOf(rest, g.count - front)};
            g = {g.first, front, boxOf(g.first, front)};
        }
        Node n;
        const float wider = tree.wider;
        for (int i = 0; i < 8; ++i) {
            // Empty children lie infinitely far away
            Bounds b = {{kInfinity, kInfinity, kInfinity}, {kInfinity, kInfinity, kInfinity}};
            if (i < count) b = parts[i].box;
            n.lo[0][i] = b.lo.x - wider, n.lo[1][i] = b.lo.y - wider, n.lo[2][i] = b.lo.z - wider;
            n.hi[0][i] = b.hi.x + wider, n.hi[1][i] = b.hi.y + wider, n.hi[2][i] = b.hi.z + wider;
            n.child[i] = i >= count               ? -1
                         : parts[i].count > kLeaf ? build(parts[i], deep + 3)
                                                  : leaf(parts[i]);
        }
        tree.nodes[(size_t)index] = n;
        return index;
    }
};

RayTree::RayTree(const std::vector<Corners> &triangles) {
    Builder b = {*this, triangles, {}};
    for (const Corners &corners : triangles) {
        Bounds box = kNoBounds;
        for (const Vec3 &c : corners) include(box, {c, c});
        b.items.push_back({box, (int)b.items.size()});
    }
    nodes.reserve(triangles.size() / 12 + 16), leaves.reserve(triangles.size() / 4 + 16);
    auto count = (int)triangles.size();
    Bounds all = b.boxOf(0, count);
    if (count) wider = sumAbs(all.hi - all.lo) * Builder::kWider;
    b.build({0, count, all}, 0);
}

} // namespace odraz::radiosity
