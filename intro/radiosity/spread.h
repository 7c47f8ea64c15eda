// Moves light between texels and patches, in both directions.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Averages a plane over the visible places of every patch: means in mean[patch * stride].
void meansOfPatches(const Model &model, const float *plane, float *mean, int stride);

// Spreads values of patches ([patches][columns], `columns` a multiple of 8) over the texels. They are
// interpolated bilinearly between the middles of patches and extrapolated beyond these, but not below half of
// the least of the four. Column k is added to planes[k], for `count` columns. The first `tied` columns may be
// negative, and their proportions matter: all of them are extrapolated only as far as the first one may be.
void addToTexels(const Model &model, const float *values, int columns, float *const *planes, int count,
                 Workers &workers, int tied = 0);

} // namespace odraz
