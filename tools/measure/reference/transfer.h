// Measures the error of the hall's transfer: its relit light against radiosity solutions made for that light.
#pragma once

#include "tools/measure/reference/reference_hall.h"

#include <vector>

namespace odraz::measure {

// The errors of the relit hall at one hour. The reference is solved for the exact sky and sun of that hour,
// from the same form factors.
struct DayError {
    float hour;
    double lightmap, whole; // rms, percent: of the light in the lightmap; of all light, with the sun's
};
// For at most 10 hours, since each has three skies.
std::vector<DayError> dayErrors(const std::vector<float> &hours, const Gl &gl, Workers &workers);

} // namespace odraz::measure
