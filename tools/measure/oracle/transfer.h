// Measures the hall's transfer: its light against radiosity solutions made for exactly that light.
#pragma once

#include "tools/measure/oracle/reference_hall.h"

#include <vector>

namespace odraz::measure {

// The relit hall's errors over the day. Each reference is solved for the exact sky and sun of its hour, from
// the same form factors.
struct DayError {
    float hour;
    double lightmap, whole; // rms, percent: of the light in the lightmap; of all light, the sun's included
};
std::vector<DayError> dayErrors(const std::vector<float> &hours, const Gl &gl, Workers &workers);

} // namespace odraz::measure
