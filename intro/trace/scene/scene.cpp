#include "trace/scene/scene.h"

namespace odraz {

Shape triangle(Vec3 corner, Vec3 u, Vec3 v, Vec3 n) {
    Shape s = {};
    s.kind = ShapeKind::Triangle;
    s.centre = corner;
    // Rows that give 1 at the end of one side and 0 along the other
    Vec3 a = cross(v, n), b = cross(n, u);
    s.frame = {a * (1 / dot(a, u)), n, b * (1 / dot(b, v))};
    float size = max(length(u), length(v));
    s.half = {size, 0, size};
    // Wider by more than the rounding of a point, as rectangles are
    s.half.y = (sumAbs(corner) + 2 * size) * 5e-7f * max(length(s.frame.u), length(s.frame.w));
    s.chart = -1;
    return s;
}

void Scene::clear() {
    shapeCount = materialCount = lightCount = outlineCount = 0;
    sky = {};
    ambientLow = ambientHigh = {};
    fog = lines = 0;
    lightmap = nullptr;
    exposure = 1;
    contact = false;
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

} // namespace odraz
