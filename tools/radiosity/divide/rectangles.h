// Divides regions of a plane into rectangles along its axes.
#pragma once

#include <array>
#include <vector>

namespace odraz::radiosity {

using Vec2d = std::array<double, 2>;

struct Rectangle {
    double u0, v0, u1, v1;
};

// The rectangles of a region whose borders all run along u or v; empty if some do not. Divides it into slabs
// at each v where a border along v ends. Lengths below `tiny` count as zero.
std::vector<Rectangle> rectanglesOf(const std::vector<std::array<Vec2d, 2>> &borders, double tiny);

} // namespace odraz::radiosity
