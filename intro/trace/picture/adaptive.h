// Adaptive anti-aliasing: one quadtree of squares that share corners, from 8 pixels down to one.
//
// Every corner is traced once; what splits a square stands in criterion.h. What need not split is filled by
// bilinear interpolation (fill.h): of light alone, the diffuse colour is taken at every pixel. Source: the
// intro thesis. Below a pixel the thesis splits on, into squares of a quarter; here a pixel gets samples that
// stand where they tell most about an edge, of whatever slope.
#pragma once

#include "trace/picture/tile.h"

namespace odraz {

void traceAdaptive(Tile &t);

} // namespace odraz
