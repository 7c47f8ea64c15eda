// The sky: what a ray meets that meets nothing else.
#pragma once

#include "base/vec3.h"

namespace odraz {

// Radiances. From the horizon's colour to the zenith's by elevation; the ground below; around the sun a glow
// that falls with the fourth power of the cosine, and nearer to it a brighter one.
struct Sky {
    Rgb low, high, ground;
    Vec3 sun; // unit
    Rgb glow; // {} where no sun is seen
};

// One without sun and ground: the horizon's colour goes on below it.
inline Sky plainSky(Rgb low, Rgb high) { return {low, high, low, {0, 1, 0}, {}}; }

// The radiance from unit directions.
Rgb8 radiance(const Sky &sky, const Vec3x8 &d);

} // namespace odraz
