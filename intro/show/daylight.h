// The hours of the hall's day: sun and sky.
#pragma once

#include "trace/scene/sky.h"

namespace odraz {

// The hours that are given; all others lie between two of them.
enum Hour { kSunrise, kMorning, kForenoon, kNoon, kAfternoon, kEvening, kSunset, kNight, kHours };

// The sky of an hour, kSunrise .. kNight, and its sun.
struct Daylight {
    Sky sky;
    Vec3 sunAt;   // world
    Rgb sunlight; // irradiance / pi on what faces it
};
Daylight daylightAt(float hour);

} // namespace odraz
