// The sky's light on a model's texels, by rays.
#pragma once

#include "base/parallel.h"
#include "radiosity/model.h"
#include "tools/radiosity/read/surroundings.h"

namespace odraz::radiosity {

// Adds the sky's light to the texels, in three planes of irradiance / pi. Rays go through a grid over the
// cosine-weighted hemisphere, a quarter of them from each of a texel's four places; the grid is rotated
// differently at every texel. `rays` is the square of an even number.
void addSky(const Model &model, const Scene &scene, const SkyPicture &sky, int rays, Workers &workers,
            float *const *direct);

} // namespace odraz::radiosity
