// Ties: hidden texels get light from their neighbours, which prevents dark rims.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Ties hidden texels to their neighbours.
void tie(Model &model);
// Applies the ties to the values of a plane.
void applyTies(const Model &model, float *plane);

} // namespace odraz
