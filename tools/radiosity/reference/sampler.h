// Random numbers and directions for the oracles, in double precision.
#pragma once

#include "tools/engine/vec3d.h"

#include <array>
#include <cstdint>

namespace odraz::radiosity {

// splitmix64 (Steele, Lea and Flood, 2014): a hash of 64 bits.
uint64_t mixed(uint64_t x);

// The random numbers of one sample, each 0 <= x < 1. Every pixel or place has a different stream.
class Sampler {
public:
    explicit Sampler(uint64_t stream, uint64_t sample = 0);

    double random();
    // Number k < kEven of this sample. Over all samples of a stream these numbers fill a cube of kEven
    // dimensions evenly (Roberts' additive recurrence, shifted at random).
    double even(size_t k) const;
    static constexpr size_t kEven = 8;

private:
    uint64_t state, sample, shift;
};

// A point in the unit square.
struct SquarePoint {
    double a, b;
};
// A random point in cell k of a grid of side x side cells.
SquarePoint inCell(Sampler &sampler, int k, int side);

// Maps the unit square evenly to a triangle.
Vec3d onTriangle(const std::array<Vec3d, 3> &corners, SquarePoint at);
// Maps the unit square to directions about a normal, by the cosine law.
Vec3d byCosine(Vec3d normal, SquarePoint at);
// Maps the unit square evenly to the directions of a cone; `cosine` is that of the angle between its axis and
// its side.
Vec3d inCone(Vec3d axis, double cosine, SquarePoint at);

// The cosine for the cone in which a ball is seen from outside.
double coneOfBall(double distance, double radius);

} // namespace odraz::radiosity
