// One shape of each kind, for tests of all kinds. A new kind needs a case in the switch.
#pragma once

#include "trace/scene/shape.h"

namespace odraz {

// A shape with a given centre, in the world's frame. Kinds with fewer than three sizes use the first ones.
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
