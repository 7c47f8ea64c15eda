// Real spherical harmonics of the bands 0 to 4: 25 numbers that stand for light from all around.
//
// Coefficient l (l + 1) + m belongs to the band l and the order m, -l .. l; the pole is the world's y, and m
// > 0 goes with the cosine of the angle from z towards x. The basis is orthonormal over the sphere, with the
// Condon-Shortley phase: that of Sloan, "Stupid Spherical Harmonics (SH) Tricks" (2008), its axes renamed.
// Functions of a higher frequency than band 4 are blurred to some 45 degrees; step-like ones overshoot (ring)
// unless they are windowed.
#pragma once

#include "trace/scene/sky.h"

namespace odraz {

inline constexpr int kBands = 5, kSh = kBands * kBands;

// The 25 functions in unit directions d.
void evaluate(const Vec3x8 &d, Float8 *y);

// Directions over the sphere, eight at a time, and the solid angle that each stands for: Gauss's along the
// pole's axis, evenly around it. Exact for polynomials up to degree 31.
inline constexpr int kDirections = 1024;
Vec3x8 direction(int first, float &solidAngle);

// A sky's coefficients, red, green and blue.
void project(const Sky &sky, Rgb *light);

// What a band l is to be multiplied by, e^(-l (l + 1) / (2 exponent)): convolution with a lobe that falls
// about as cos^exponent. The lobe of the heat equation is nowhere negative, and what it blurs does not ring.
float window(int band, float exponent);

} // namespace odraz
