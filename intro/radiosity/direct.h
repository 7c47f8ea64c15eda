// Direct light on texels, from skies through windows, suns and lamps. The tracer traces the shadow rays.
//
// Each texel is sampled at its visible points, up to four. Light sources with an area are divided into parts.
// Far from a source, each point uses every fourth part, and the four points together use all: penumbrae are
// smooth, and no random numbers are needed. There a part counts as a disc, cos cos' A / (pi r^2 + A)
// (Wallace, Elmquist and Haines, "A Ray Tracing Algorithm for Progressive Radiosity", SIGGRAPH 1989). Near a
// source, each point uses all parts, by Lambert's exact formula. Balls have an exact form factor. One shadow
// ray to each part or ball decides visibility.
#pragma once

#include "base/parallel.h"
#include "base/progress.h"
#include "radiosity/light_bases.h"
#include "radiosity/visible.h"

namespace odraz {

// Finds the direct light of all texels: direct[k] is a plane with the share of basis k that arrives. The
// scene must contain the posed, finished model.
void findDirectLight(const Model &model, const Scene &scene, const LightBases &bases, Workers &workers,
                     float *const *direct, const Progress &progress);

} // namespace odraz
