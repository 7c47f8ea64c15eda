// Adaptive anti-aliasing: one quadtree of squares that share corners, from 8 pixels down to one.
//
// Every corner is traced once, or is the mean of two; criterion.h decides which, and which squares split.
// Squares that do not split are filled by bilinear interpolation (fill.h). Only light is interpolated; the
// diffuse colour is evaluated at every pixel. Source: a thesis on a ray-traced 64 kB intro ("the intro
// thesis"). It also splits pixels, into quarters. Here a pixel gets samples inside, at positions chosen for
// edges of any slope.
#pragma once

#include "trace/picture/tile.h"

namespace odraz {

void traceAdaptive(Tile &t);

} // namespace odraz
