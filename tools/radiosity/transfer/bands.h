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

// A rotation, by its rows.
struct Turn {
    Vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    Vec3 of(const Vec3 &v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
    Turn inverse() const { return {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}; }
};
// Degrees about an axis of length 1, counter-clockwise as seen from its tip.
Turn turnAbout(const Vec3 &axis, double degrees);
// First `first`, then `second`.
Turn operator*(const Turn &second, const Turn &first);

// The light after rotating the sphere: light from d then comes from turn.of(d). Rotation does not mix bands,
// so nothing is lost. Computed by quadrature, which is exact for six bands.
BandLight turned(const BandLight &light, int bands, const Turn &turn);

} // namespace odraz::radiosity
