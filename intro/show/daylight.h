// Sun and sky of the hall's day.
#pragma once

#include "trace/scene/sky.h"

namespace odraz {

// The hours that are defined; all others are interpolated between two of them.
enum Hour { kSunrise, kMorning, kForenoon, kNoon, kAfternoon, kEvening, kSunset, kNight, kHours };

// The sky and the sun at one hour.
struct Daylight {
    Sky sky;
    Vec3 sunAt;   // position in the world
    Rgb sunlight; // irradiance / pi on a surface that faces the sun
};
Daylight daylightAt(float hour); // kSunrise .. kNight

} // namespace odraz
