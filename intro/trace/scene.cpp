#include "trace/scene.h"

namespace odraz {

void Scene::clear() {
    shapeCount = materialCount = lightCount = outlineCount = 0;
    sky = {};
    ambientLow = ambientHigh = {};
    fog = lines = 0;
    lightmap = nullptr;
    exposure = 1;
}

Shape *Scene::add(const Shape &s) {
    if (shapeCount == kMaxShapes) return &shapes[kMaxShapes - 1];
    shapes[shapeCount] = s;
    return &shapes[shapeCount++];
}

Shape *Scene::addPolygon(Vec3 centre, const Mat3 &frame, const float *points, int count, int material) {
    if (outlineCount + count > kMaxOutline) count = kMaxOutline - outlineCount;
    Shape s = {ShapeKind::Polygon,
               (uint8_t)material,
               (uint16_t)outlineCount,
               (uint16_t)count,
               centre,
               {},
               frame,
               false,
               {},
               -1};
    for (int i = 0; i < 2 * count; ++i) outline[2 * outlineCount + i] = points[i];
    outlineCount += count;
    return add(s);
}

static constexpr Bounds kNothing = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

static void include(Bounds &b, Vec3 lo, Vec3 hi) {
    b.lo = {min(b.lo.x, lo.x), min(b.lo.y, lo.y), min(b.lo.z, lo.z)};
    b.hi = {max(b.hi.x, hi.x), max(b.hi.y, hi.y), max(b.hi.z, hi.z)};
}

static Bounds bounds(const Scene &scene, const Shape &s) {
    if (s.kind == ShapeKind::Polygon) {
        Bounds b = kNothing;
        for (int i = 0; i < s.vertexCount; ++i) {
            const float *v = scene.outline + 2 * (s.firstVertex + i);
            Vec3 p = s.centre + transposeTimes(s.frame, Vec3{v[0], 0, v[1]});
            include(b, p, p);
        }
        return b;
    }
    Vec3 r = s.half;
    if (s.kind != ShapeKind::Sphere) {
        Vec3 u = s.frame.u * s.half.x, v = s.frame.v * s.half.y, w = s.frame.w * s.half.z;
        r = {abs(u.x) + abs(v.x) + abs(w.x), abs(u.y) + abs(v.y) + abs(w.y), abs(u.z) + abs(v.z) + abs(w.z)};
    }
    return {s.centre - r, s.centre + r};
}

static float component(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

static float halfArea(const Bounds &b) {
    Vec3 e = b.hi - b.lo;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

// Splits a node's shapes along the axis on which their middles spread most, where the surface area heuristic
// (Goldsmith and Salmon, 1987) is least, down to leaves of two. Recursion is at most kMaxDeep deep: below
// that, and so for shapes that coincide, leaves hold what is left.
static constexpr int kMaxDeep = 28;
static void build(Scene &s, int node, int first, int count, int deep) {
    // Bound shapes and their middles
    const Bounds *b = s.box;
    Bounds all = kNothing, middles = kNothing;
    auto middle = [&](int i) { return (b[s.order[i]].lo + b[s.order[i]].hi) * 0.5f; };
    for (int i = first; i < first + count; ++i) {
        include(all, b[s.order[i]].lo, b[s.order[i]].hi);
        include(middles, middle(i), middle(i));
    }
    // Grow by the slab test's rounding
    Vec3 size = {max(abs(all.lo.x), abs(all.hi.x)), max(abs(all.lo.y), abs(all.hi.y)),
                 max(abs(all.lo.z), abs(all.hi.z))};
    Vec3 margin = size * 4e-6f + Vec3{1e-7f, 1e-7f, 1e-7f};
    Node &n = s.nodes[node];
    n = {all.lo - margin, first, all.hi + margin, count};
    Vec3 extent = middles.hi - middles.lo;
    if (count <= 2 || deep == kMaxDeep || maxComponent(extent) == 0) return;

    // Sort along the axis
    int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    for (int i = first + 1; i < first + count; ++i) {
        uint16_t moved = s.order[i];
        float key = component(middle(i), axis);
        int j = i;
        for (; j > first && component(middle(j - 1), axis) > key; --j) s.order[j] = s.order[j - 1];
        s.order[j] = moved;
    }
    // Sweep from both ends for the split of least area times count
    float left[kMaxShapes];
    Bounds swept = kNothing;
    for (int i = 1; i < count; ++i) {
        include(swept, b[s.order[first + i - 1]].lo, b[s.order[first + i - 1]].hi);
        left[i] = halfArea(swept) * (float)i;
    }
    swept = kNothing;
    int best = count / 2;
    float least = kInfinity;
    for (int i = count - 1; i > 0; --i) {
        include(swept, b[s.order[first + i]].lo, b[s.order[first + i]].hi);
        float cost = left[i] + halfArea(swept) * (float)(count - i);
        if (cost < least) {
            least = cost;
            best = i;
        }
    }
    int child = s.nodeCount;
    s.nodeCount += 2;
    n.first = child;
    n.count = 0;
    build(s, child, first, best, deep + 1);
    build(s, child + 1, first + best, count - best, deep + 1);
}

void Scene::finish() {
    int bounded = 0;
    unboundedCount = occluderCount = nodeCount = 0;
    for (int i = 0; i < shapeCount; ++i) {
        Shape &s = shapes[i];
        s.aligned = s.frame.u.x == 1 && s.frame.v.y == 1 && s.frame.w.z == 1;
        if (s.kind == ShapeKind::Plane) {
            if (unboundedCount < 8) unbounded[unboundedCount++] = (uint16_t)i;
            continue;
        }
        box[i] = bounds(*this, s);
        order[bounded++] = (uint16_t)i;
        if (s.kind == ShapeKind::Sphere && occluderCount < kMaxOccluders &&
            maxComponent(materials[s.material].emit) == 0) {
            occluder[occluderCount] = s.centre;
            occluderRadius[occluderCount++] = s.half.x;
        }
    }
    if (bounded) {
        nodeCount = 1;
        build(*this, 0, 0, bounded, 0);
    }
    for (int i = 0; i < materialCount; ++i) mean[i] = meanAlbedo(materials[i]) * materials[i].diffuse;
}

} // namespace odraz
