// Regions of a plane as rectangles along its axes.
#pragma once

#include <array>
#include <vector>

namespace odraz {

using Vec2d = std::array<double, 2>;

struct Rectangle {
    double u0, v0, u1, v1;
};

// Divides what lies between upright borders into rectangles, if all borders of the region run along u or v:
// slab by slab, between the heights at which borders end. Lengths below `tiny` count as none. Empty if it is
// not made of rectangles.
std::vector<Rectangle> rectanglesOf(const std::vector<std::array<Vec2d, 2>> &borders, double tiny);

} // namespace odraz
