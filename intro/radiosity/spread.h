// Light between texels and patches, down and up.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Averages a plane over the places of every patch that can be seen: means in mean[patch * stride].
void meansOfPatches(const Model &model, const float *plane, float *mean, int stride);

// Spreads values of patches ([patches][columns], `columns` a multiple of 8) over the texels: bilinear between
// the patches' middles, straight on outside of them, but not below half of the least. Column k is added to
// planes[k], for `count` of them. The first `tied` columns may be negative and must stay a linear system: all
// go as far outside as the first one may.
void addToTexels(const Model &model, const float *values, int columns, float *const *planes, int count,
                 Workers &workers, int tied = 0);

} // namespace odraz
