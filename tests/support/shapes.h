// Scenes for tests: an empty one, and one shape of each kind.
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

inline std::unique_ptr<Scene> emptyScene() {
    auto scene = std::make_unique<Scene>();
    scene->clear();
    return scene;
}

// A diffuse surface.
inline Material matte(Rgb colour) {
    return {.texture = {Pattern::Plain, 1, {colour, colour, colour, colour}}, .diffuse = 1};
}

// A rectangle around a centre with unit sides u and v, lit on the side of u x v.
inline Shape rect(Vec3 centre, Vec3 u, Vec3 v, float halfU, float halfV, int material = 0) {
    return {.kind = ShapeKind::Rect,
            .material = (uint8_t)material,
            .centre = centre,
            .half = {halfU, 0, halfV},
            .frame = {u, cross(u, v), v}};
}

// Returns a shape of a kind, parallel to the world's axes. Kinds with fewer than three sizes use the first
// ones. A new kind needs a case in the switch.
inline Shape shapeOf(ShapeKind kind, const Vec3 &centre, const Vec3 &half) {
    switch (kind) {
    case ShapeKind::Sphere:
        return sphere(centre, half.x, 0);
    case ShapeKind::Plane:
        return plane(centre, 0);
    case ShapeKind::Box:
        return box(centre, half, 0);
    case ShapeKind::Cylinder:
        return cylinder(centre, half.x, half.y, 0);
    case ShapeKind::Rect:
        return {.kind = ShapeKind::Rect, .centre = centre, .half = {half.x, 0, half.y}};
    case ShapeKind::Count:
        break;
    }
    __builtin_unreachable();
}

// Returns the distance of a point from a shape, 0 or less inside it. A new kind needs a case in the switch.
inline float distanceFrom(const Shape &s, Vec3 p) {
    Vec3 q = s.frame * (p - s.centre);
    auto over = [](float x, float half) { return std::fmax(std::fabs(x) - half, 0.f); };
    switch (s.kind) {
    case ShapeKind::Sphere:
        return length(q) - s.half.x;
    case ShapeKind::Plane:
        return q.y;
    case ShapeKind::Box:
    case ShapeKind::Rect: // its half.y is 0
        return length(Vec3{over(q.x, s.half.x), over(q.y, s.half.y), over(q.z, s.half.z)});
    case ShapeKind::Cylinder:
        return std::hypot(over(std::hypot(q.x, q.z), s.half.x), over(q.y, s.half.y));
    case ShapeKind::Count:
        break;
    }
    ADD_FAILURE() << "distanceFrom() has no case for shapes of kind " << (int)s.kind;
    return 0;
}

} // namespace odraz
