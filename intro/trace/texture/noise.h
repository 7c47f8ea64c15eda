// Perlin's improved gradient noise, eight points at a time.
//
// Quintic fade of Perlin, "Improving Noise" (SIGGRAPH 2002); in place of his permutation table the lattice is
// hashed with integers, so that there is no period of 256 and no table; in place of his twelve gradients
// there are eight, evenly spread. Coordinates: |x| < 2^22 for full detail, any finite number for a finite
// answer.
#pragma once

#include "base/vec3.h"

namespace odraz {

// In [-1, 1], 0 at every lattice point, mean 0.
Float8 noise(const Vec3x8 &p);

// Sum over octaves of weaker^i noise(finer^i p), i < octaves. `width` is the side of the box that a sample
// covers, in lattice cells: octaves whose cells come near it fade out, and those that are gone cost nothing.
Float8 fractalNoise(const Vec3x8 &p, int octaves, Float8 width, float finer = 2, float weaker = 0.5f);

// How much of a detail of the given size is left when averaged over `width`: 1 .. 0.
Float8 bandLimit(Float8 width, float size);

} // namespace odraz
