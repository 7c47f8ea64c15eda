// The light of a moment, from a room's bases: what transfer is for. Nothing but multiplications and
// additions, a row for each texel.
#pragma once

#include "radiosity/radiosity.h"

namespace odraz {

// How much of each basis there is.
struct LightVector {
    Rgb bounced[kMaxBases]; // coefficients of skies, sunlight, radiances of lamps
    Rgb direct[kMaxBases];  // the same; {} for skies, and where the tracer draws what they light directly
};

// All of it on every texel.
void relight(const Radiosity &r, const Model &model, const LightVector &light, float *const plane[3]);

} // namespace odraz
