// The sky: what a ray meets that meets nothing else.
#pragma once

#include "base/vec3.h"

namespace odraz {

// Radiance: low + slope y + curve y^2, where y is the sine of the elevation, or `least` if y is smaller.
// Around the sun a wide glow; with least = -1 both are polynomials of degree 4, which spherical harmonics of
// bands 0 to 4 hold without an error. Nearer to the sun a small bright one, and over all that clouds of
// noise.
struct Sky {
    Rgb low, slope, curve;
    float least;
    Vec3 sun;       // unit
    Rgb glow, near; // {} where no sun is seen
    Rgb clouds;     // their radiance
    float cover;    // 0: no clouds; 1: hardly anything else
    float drift;    // how far they have moved
};

// From the horizon's colour to the zenith's; the horizon's goes on below it.
Sky plainSky(const Rgb &low, const Rgb &high);

// Irradiance / pi of the near glow on what faces it: as if the sun were that much stronger.
inline constexpr float kNearGlow = 2 / 66.f;

// The radiance from unit directions.
Rgb8 radiance(const Sky &sky, const Vec3x8 &d);

} // namespace odraz
