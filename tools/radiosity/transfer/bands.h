// Spherical harmonics of up to six bands: the film's five (transfer/spherical_harmonics.h), and band 5.
//
// Light from all directions is a list of bands x bands coefficients, each red, green and blue. Coefficient
// l (l + 1) + m belongs to band l and order m. The basis is orthonormal, so the squares of a function's
// coefficients sum to the integral of its square.
#pragma once

#include "transfer/spherical_harmonics.h"

#include <array>

namespace odraz::radiosity {

inline constexpr int kMostBands = 6, kMostSh = kMostBands * kMostBands;

// Evaluates the functions of 1 .. kMostBands bands at unit directions d. `y` has room for kMostSh.
void evaluateBands(const Vec3x8 &d, int bands, Float8 *y);

using BandLight = std::array<Rgb, kMostSh>; // zero beyond the bands in use

// The band that a coefficient belongs to.
int bandOf(int coefficient);

// The light from a direction, summed over the first `bands` bands.
Rgb radiance(const BandLight &light, int bands, const Vec3 &d);

// A rotation about an axis of length 1, counter-clockwise as seen from the axis's tip.
Mat3 turnAbout(const Vec3 &axis, double degrees);

// The light after a rotation: light from d then comes from turn * d. Nothing is lost, because rotation does
// not mix bands. Computed by quadrature, which is exact for six bands.
BandLight turned(const BandLight &light, int bands, const Mat3 &turn);

} // namespace odraz::radiosity
