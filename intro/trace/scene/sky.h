// The sky: what a ray sees when it hits nothing.
#pragma once

#include "base/vec3.h"

namespace odraz {

// Radiance is low + slope y + curve y^2, where y is the sine of the elevation, but at least `least`. A wide
// glow around the sun is added. With least = -1 the sum is a polynomial of degree 4, which spherical
// harmonics of bands 0 to 4 represent exactly. A small bright glow is added near the sun, then clouds.
struct Sky {
    Rgb low, slope, curve;
    float least;
    Vec3 sun;             // unit
    Rgb glow, near;       // the wide and the small glow; {} if no sun is seen
    Rgb clouds;           // radiance of clouds
    float cover;          // 0: no clouds; 1: almost nothing but clouds
    float drift;          // distance that the clouds have moved
    float cloudScale = 1; // smaller values give larger and calmer clouds
};

// A gradient from the horizon's colour to the zenith's; below the horizon, the horizon's.
Sky plainSky(const Rgb &low, const Rgb &high);

// Irradiance / pi of a surface that faces the sun, by the near glow, per unit of Sky::near.
inline constexpr float kNearGlow = 2 / 66.f;

// The radiance from unit directions. Clouds are averaged over `width`, an angle in radians at the zenith, and
// the near glow over `spread`, the angle of a sample: a small ball mirrors it less than a pixel wide.
inline constexpr float kSharpClouds = 0.014f;
Rgb8 radiance(const Sky &sky, const Vec3x8 &d, float width = kSharpClouds, Float8 spread = Float8{});

} // namespace odraz
