// Random numbers and directions for the references, in double precision.
#pragma once

#include "tools/support/vec3d.h"

#include <array>
#include <cstdint>

namespace odraz::radiosity {

// Random numbers, each 0 <= x < 1. Every stream has different numbers.
class Sampler {
public:
    explicit Sampler(uint64_t stream);

    double random();

private:
    uint64_t state;
};

// A point in the unit square.
struct SquarePoint {
    double a, b;
};
// A random point in cell k of a grid of side x side cells.
SquarePoint inCell(Sampler &sampler, int k, int side);

// Maps the unit square evenly to a triangle.
Vec3d onTriangle(const std::array<Vec3d, 3> &corners, SquarePoint at);
// Maps the unit square to directions about a normal, distributed by the cosine law.
Vec3d byCosine(Vec3d normal, SquarePoint at);

} // namespace odraz::radiosity
