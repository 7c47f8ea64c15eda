// The hours of the hall's day: sun and sky.
#pragma once

#include "trace/scene/sky.h"

namespace odraz {

inline constexpr int kHours = 8; // from dawn (0) to dusk (6) and night (7)
inline constexpr int kNoon = 3;

// The sky of an hour, 0 .. kHours - 1, and its sun.
struct Daylight {
    Sky sky;
    Vec3 sunAt;   // world
    Rgb sunlight; // irradiance / pi on what faces it
};
Daylight daylightAt(float hour);

} // namespace odraz
