// Real spherical harmonics of bands 0 to 4: 25 coefficients that describe light from all directions.
//
// Coefficient l (l + 1) + m is for band l and order m, -l .. l. The pole is the world's y. Orders m > 0 have
// the cosine of the angle from z towards x. The basis is orthonormal over the sphere, with the
// Condon-Shortley phase, as in Sloan, "Stupid Spherical Harmonics (SH) Tricks" (2008), with the axes renamed.
// Detail finer than band 4, about 45 degrees, is lost. Functions with steps overshoot (ring) unless they are
// windowed.
#pragma once

#include "trace/scene/sky.h"

namespace odraz {

inline constexpr int kBands = 5, kSh = kBands * kBands;

// Evaluates the 25 functions for unit directions d.
void evaluate(const Vec3x8 &d, Float8 *y);

// Returns eight of kDirections directions over the sphere, from index `first` on, and the solid angle of
// each. They are Gauss points along the pole's axis and evenly spaced around it. Exact for polynomials up to
// degree 31.
inline constexpr int kDirections = 1024;
Vec3x8 direction(int first, float &solidAngle);

// Computes a sky's coefficients, in red, green and blue.
void project(const Sky &sky, Rgb *light);

// Returns the factor for band l, e^(-l (l + 1) / (2 exponent)). It convolves a function with a lobe that is
// roughly cos^exponent. This lobe is the kernel of the heat equation: it is never negative, so the blurred
// function does not ring.
float window(int band, float exponent);

} // namespace odraz
