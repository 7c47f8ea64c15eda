// Texels whose light follows from others': those that hang in the middle of a larger neighbour's side, and
// those that are hidden. With them light has neither cracks nor dark rims.
#pragma once

#include "radiosity/elements.h"

namespace odraz {

// Ties hanging and hidden texels, and sums up what of each patch is to be seen, once the cells are final.
void tie(Model &model);
// Moves the values of a plane as the ties say.
void settle(const Model &model, float *plane);

} // namespace odraz
