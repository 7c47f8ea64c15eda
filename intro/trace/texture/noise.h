// Perlin's improved gradient noise, eight points at a time.
//
// The fade is quintic, as in Perlin, "Improving Noise" (SIGGRAPH 2002). His permutation table with its
// period of 256 is replaced by an integer hash of the lattice, his twelve gradients by eight, evenly spread.
// Coordinates below 2^22 have full detail; all finite ones give finite values.
#pragma once

#include "base/vec3.h"

namespace odraz {

// Returns values in [-1, 1]: 0 at every lattice point, 0 in the mean.
Float8 noise(const Vec3x8 &p);

// Sum of weaker^i noise(finer^i p) over octaves i < octaves. `width` is the side of the box that a sample
// covers, in lattice cells. Octaves whose cells are about that small fade out; faded ones cost nothing.
Float8 fractalNoise(const Vec3x8 &p, int octaves, Float8 width, float finer = 2, float weaker = 0.5f);

// The share (1 .. 0) of a detail of the given size that is left when averaged over `width`.
Float8 bandLimit(Float8 width, float size);

} // namespace odraz
