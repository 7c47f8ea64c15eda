#include "trace/scene/shape.h"

namespace odraz {

Shape triangle(const Vec3 &corner, const Vec3 &u, const Vec3 &v, const Vec3 &n) {
    Shape s = {.kind = ShapeKind::Triangle, .centre = corner};
    // Rows that give 1 at the end of one side and 0 along the other
    Vec3 a = cross(v, n), b = cross(n, u);
    s.frame = {a * (1 / dot(a, u)), n, b * (1 / dot(b, v))};
    float size = max(length(u), length(v));
    s.half = {size, 0, size};
    // Widen it by more than the rounding error of a point, as rectangles are
    s.half.y = (sumAbs(corner) + 2 * size) * 5e-7f * max(length(s.frame.u), length(s.frame.w));
    return s;
}

} // namespace odraz
