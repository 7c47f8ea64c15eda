// Spherical harmonics of up to six bands: those of the film (transfer/spherical_harmonics.h), and band 5.
//
// Light from all directions is a list of coefficients, bands x bands of them, each red, green and blue.
// Coefficient l (l + 1) + m belongs to band l and order m. The basis is orthonormal, so the squares of a
// function's coefficients sum to the integral of its square.
#pragma once

#include "transfer/spherical_harmonics.h"

#include <array>

namespace odraz::radiosity {

inline constexpr int kMostBands = 6, kMostSh = kMostBands * kMostBands;

// The first bands x bands functions at unit directions d; `y` has room for kMostSh. bands: 1 .. kMostBands
void evaluateBands(const Vec3x8 &d, int bands, Float8 *y);

using BandLight = std::array<Rgb, kMostSh>; // zero beyond the bands in use

// The band that a coefficient belongs to.
int bandOf(int coefficient);

// The light in a direction, summed over the first `bands`.
Rgb radiance(const BandLight &light, int bands, const Vec3 &d);

// A rotation: degrees about an axis of length 1, counter-clockwise as seen from its tip.
Mat3 turnAbout(const Vec3 &axis, double degrees);

// The light after rotating the sphere: light from d then comes from turn * d. Rotation does not mix bands,
// so nothing is lost. Computed by quadrature, which is exact for six bands.
BandLight turned(const BandLight &light, int bands, const Mat3 &turn);

} // namespace odraz::radiosity
