// Glowing balls in mirrors and through glass, drawn at least as large as a sample.
//
// The image of a lamp in a mirror ball is smaller than the distance between samples, and many times white. If
// one sample hit it and the next one did not, it would blink. So secondary rays pass through balls that only
// glow; instead, the ball's image is widened to what the sample covers, and paled in proportion.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Adds the glowing balls that stand before what the rays of a stream have hit. (As shapes that rays hit they
// add nothing, see contribute.cpp.)
void addGlowingBalls(const Context &c, const RayStream &in);

} // namespace odraz
