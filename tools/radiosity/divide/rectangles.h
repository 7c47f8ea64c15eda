// Divides regions of a plane into rectangles along its axes.
#pragma once

#include <array>
#include <vector>

namespace odraz::radiosity {

using Vec2d = std::array<double, 2>;

struct Rectangle {
    double u0, v0, u1, v1;
};

// Divides the area between upright borders into rectangles, if all borders of the region run along u or v. It
// goes slab by slab, from one height at which a border ends to the next. Lengths below `tiny` count as zero.
// Empty if the region is not made of rectangles.
std::vector<Rectangle> rectanglesOf(const std::vector<std::array<Vec2d, 2>> &borders, double tiny);

} // namespace odraz::radiosity
