// The sky: what a ray sees when it hits nothing.
#pragma once

#include "base/vec3.h"

namespace odraz {

// Radiance is low + slope y + curve y^2, where y is the sine of the elevation, or `least` if that is greater.
// A wide glow around the sun is added. With least = -1 the sum is a polynomial of degree 4, which spherical
// harmonics of bands 0 to 4 represent exactly. A small bright glow near the sun is added too, and clouds of
// noise cover all of that.
struct Sky {
    Rgb low, slope, curve;
    float least;
    Vec3 sun;             // unit
    Rgb glow, near;       // {} if no sun is seen
    Rgb clouds;           // their radiance
    float cover;          // 0: no clouds; 1: almost nothing but clouds
    float drift;          // how far they have moved
    float cloudScale = 1; // the smaller, the larger and calmer they are
};

// A gradient from the horizon's colour to the zenith's. Below the horizon it keeps the horizon's.
Sky plainSky(const Rgb &low, const Rgb &high);

// Irradiance / pi that the near glow gives to a surface facing the sun, per unit of Sky::near. It can be
// added to the sun's.
inline constexpr float kNearGlow = 2 / 66.f;

// The radiance from unit directions. Clouds lose the detail that is finer than `width`: a third of an
// angle, measured at the zenith.
inline constexpr float kSharpClouds = 0.014f;
Rgb8 radiance(const Sky &sky, const Vec3x8 &d, float width = kSharpClouds);

} // namespace odraz
