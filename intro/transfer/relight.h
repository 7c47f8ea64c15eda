// Computes a room's light at one time from its light bases: a weighted sum for each texel.
#pragma once

#include "radiosity/radiosity.h"

namespace odraz {

// The strength of each basis.
struct LightVector {
    Rgb bounced[kMaxBases]; // coefficients of skies, sunlight, radiances of lamps
    Rgb direct[kMaxBases];  // the same; {} for skies, and for lights whose direct light the tracer draws
};

// Sums the light of all bases on every texel.
void relight(const Radiosity &r, const Model &model, const LightVector &light, float *const plane[3]);

} // namespace odraz
