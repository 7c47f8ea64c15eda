// Adaptive anti-aliasing: one quadtree of squares that share corners, from 8 pixels down to a quarter.
//
// Every corner is traced once; what splits a square stands in criterion.h. What need not split is filled by
// bilinear interpolation (fill.h): of light alone, the diffuse colour is taken at every pixel. Source: the
// intro thesis.
#pragma once

#include "trace/picture/tile.h"

namespace odraz {

void traceAdaptive(Tile &t);

} // namespace odraz
