#include "trace/scene.h"

namespace odraz {

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
