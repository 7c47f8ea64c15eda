// Computes the light of one moment from a room's bases. It takes only multiplications and additions, one row
// for each texel.
#pragma once

#include "radiosity/radiosity.h"

namespace odraz {

// How strong each basis is.
struct LightVector {
    Rgb bounced[kMaxBases]; // coefficients of skies, sunlight, radiances of lamps
    Rgb direct[kMaxBases];  // the same; {} for skies and for lights whose direct light the tracer draws
};

// Sums up the light of all bases on every texel.
void relight(const Radiosity &r, const Model &model, const LightVector &light, float *const plane[3]);

} // namespace odraz
