#include "trace/scene.h"

namespace odraz {

void Scene::clear() {
    shapeCount = materialCount = lightCount = outlineCount = 0;
    skyLow = skyHigh = ambientLow = ambientHigh = {};
    fog = 0;
    exposure = 1;
}

Shape *Scene::add(const Shape &s) {
    if (shapeCount == kMaxShapes) return &shapes[kMaxShapes - 1];
    shapes[shapeCount] = s;
    return &shapes[shapeCount++];
}

Shape *Scene::addPolygon(Vec3 centre, const Mat3 &frame, const float *points, int count, int material) {
    if (outlineCount + count > kMaxOutline) count = kMaxOutline - outlineCount;
    Shape s = {ShapeKind::Polygon, (uint8_t)material, (uint16_t)outlineCount, (uint16_t)count, centre, {}, frame, {}};
    for (int i = 0; i < 2 * count; ++i) outline[2 * outlineCount + i] = points[i];
    outlineCount += count;
    return add(s);
}

Bounds bounds(const Scene &scene, const Shape &s) {
    if (s.kind == ShapeKind::Polygon) {
        Bounds b = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
        for (int i = 0; i < s.vertexCount; ++i) {
            const float *v = scene.outline + 2 * (s.firstVertex + i);
            Vec3 p = s.centre + transposeTimes(s.frame, Vec3{v[0], 0, v[1]});
            b.lo = {min(b.lo.x, p.x), min(b.lo.y, p.y), min(b.lo.z, p.z)};
            b.hi = {max(b.hi.x, p.x), max(b.hi.y, p.y), max(b.hi.z, p.z)};
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

// Splits a node's shapes at the median of their middles along the longest axis, down to leaves of two.
static void build(Scene &s, const Bounds *b, int node, int first, int count) {
    // Bound shapes and their middles
    Node &n = s.nodes[node];
    n.lo = {kInfinity, kInfinity, kInfinity};
    n.hi = -n.lo;
    Vec3 midLo = n.lo, midHi = n.hi;
    auto lower = [](Vec3 &a, Vec3 v) { a = {min(a.x, v.x), min(a.y, v.y), min(a.z, v.z)}; };
    auto raise = [](Vec3 &a, Vec3 v) { a = {max(a.x, v.x), max(a.y, v.y), max(a.z, v.z)}; };
    auto middle = [&](int i) { return (b[s.order[i]].lo + b[s.order[i]].hi) * 0.5f; };
    for (int i = first; i < first + count; ++i) {
        lower(n.lo, b[s.order[i]].lo);
        raise(n.hi, b[s.order[i]].hi);
        lower(midLo, middle(i));
        raise(midHi, middle(i));
    }
    // Grow by the slab test's rounding, so that no ray slips between a shape and its box
    Vec3 size = {max(abs(n.lo.x), abs(n.hi.x)), max(abs(n.lo.y), abs(n.hi.y)), max(abs(n.lo.z), abs(n.hi.z))};
    Vec3 margin = size * 4e-6f + Vec3{1e-7f, 1e-7f, 1e-7f};
    n.lo = n.lo - margin;
    n.hi = n.hi + margin;
    if (count <= 2) {
        n.first = first;
        n.count = count;
        return;
    }
    // Sort along the axis and halve
    Vec3 extent = midHi - midLo;
    int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    for (int i = first + 1; i < first + count; ++i) {
        uint16_t moved = s.order[i];
        float key = component(middle(i), axis);
        int j = i;
        for (; j > first && component(middle(j - 1), axis) > key; --j) s.order[j] = s.order[j - 1];
        s.order[j] = moved;
    }
    int child = s.nodeCount;
    s.nodeCount += 2;
    n.first = child;
    n.count = 0;
    build(s, b, child, first, count / 2);
    build(s, b, child + 1, first + count / 2, count - count / 2);
}

void Scene::finish() {
    Bounds box[kMaxShapes];
    int bounded = 0;
    unboundedCount = occluderCount = nodeCount = 0;
    for (int i = 0; i < shapeCount; ++i) {
        const Shape &s = shapes[i];
        if (s.kind == ShapeKind::Plane) {
            if (unboundedCount < 8) unbounded[unboundedCount++] = (uint16_t)i;
            continue;
        }
        box[i] = bounds(*this, s);
        order[bounded++] = (uint16_t)i;
        if (s.kind == ShapeKind::Sphere && occluderCount < kMaxOccluders && maxComponent(materials[s.material].emit) == 0) {
            occluder[occluderCount] = s.centre;
            occluderRadius[occluderCount++] = s.half.x;
        }
    }
    if (bounded) {
        nodeCount = 1;
        build(*this, box, 0, 0, bounded);
    }
    for (int i = 0; i < materialCount; ++i) mean[i] = meanAlbedo(materials[i]) * materials[i].diffuse;
}

} // namespace odraz
