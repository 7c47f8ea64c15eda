// Scenes for tests: an empty one, and one shape of each kind.
#pragma once

#include "trace/scene/scene.h"

#include <memory>

namespace odraz {

inline std::unique_ptr<Scene> emptyScene() {
    auto scene = std::make_unique<Scene>();
    scene->clear();
    return scene;
}

// A shape with a given centre, in the world's frame. Kinds with fewer than three sizes use the first ones. A
// new kind needs a case in the switch.
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
    case ShapeKind::Triangle:
        return triangle(centre, {half.x, 0, 0}, {0, 0, half.y}, {0, 1, 0});
    case ShapeKind::Count:
        break;
    }
    __builtin_unreachable();
}

} // namespace odraz
