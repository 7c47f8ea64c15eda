// Ties: the light of hidden texels follows from that of others, which prevents dark rims in the light.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Ties hidden texels to those around them.
void tie(Model &model);
// Applies the ties to the values of a plane.
void settle(const Model &model, float *plane);

} // namespace odraz
