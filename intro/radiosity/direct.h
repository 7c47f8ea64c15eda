// Direct light on texels: from the sky through windows, from the sun, from lamps. The tracer traces the
// shadow rays.
//
// Each texel is sampled at up to four places, those that are visible. Shining areas are divided into cells.
// Far from an area, each place uses every fourth cell, so penumbrae are even without random numbers, and a
// cell counts as a disc, cos cos' A / (pi r^2 + A) (Wallace, Elmquist and Haines, "A Ray Tracing Algorithm
// for Progressive Radiosity", SIGGRAPH 1989). Near an area, each place uses all cells, by Lambert's exact
// formula. Balls count by their exact form factor. For visibility there is one shadow ray to each cell, and
// one from each place to a ball.
#pragma once

#include "base/parallel.h"
#include "base/progress.h"
#include "radiosity/light_bases.h"
#include "radiosity/visible.h"

namespace odraz {

// Finds the direct light of all texels: direct[k] is a plane with the share of basis k that arrives. The
// scene must hold the posed, finished model.
void findDirectLight(const Model &model, const Scene &scene, const LightBases &bases, Workers &workers,
                     float *const *direct, const Progress &progress);

} // namespace odraz
