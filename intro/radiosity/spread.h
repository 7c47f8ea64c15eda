// Converts light from texels to patches and back.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Averages a plane over the visible sample points of every patch, into mean[patch * stride].
void meansOfPatches(const Model &model, const float *plane, float *mean, int stride);

// Adds values of patches ([patches][columns], `columns` a multiple of 8) to the texels. They are interpolated
// bilinearly between the four nearest centres of patches, and extrapolated outside, but not below half the
// least of the four. Column k is added to planes[k], for `count` columns. The first `coupled` columns may be
// negative, and must keep their ratios: all are extrapolated as far as the limit allows for the first.
void addToTexels(const Model &model, const float *values, int columns, float *const *planes, int count,
                 Workers &workers, int coupled = 0);

} // namespace odraz
