// Ties: the light of some texels follows from that of others. These are texels in the middle of a larger
// neighbour's side (they hang), and hidden texels. Ties prevent cracks and dark rims in the light.
#pragma once

#include "radiosity/elements.h"

namespace odraz {

// Ties hanging and hidden texels, and sums up the visible area of each patch, once the cells are final.
void tie(Model &model);
// Applies the ties to the values of a plane.
void settle(const Model &model, float *plane);

} // namespace odraz
