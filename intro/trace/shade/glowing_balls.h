// Glowing balls in mirrors and through glass, drawn at least as large as a sample.
//
// The image of a lamp in a mirror ball is smaller than the distance between samples, and many times brighter
// than white. If one sample hit it and the next one did not, it would blink. So balls that only glow add
// nothing to secondary rays that hit them; instead, the ball's image is widened to what the sample covers,
// and dimmed in proportion.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Adds the glowing balls in front of what the rays of a stream have hit. (Where rays hit such balls
// themselves, contribute.cpp adds nothing.)
void addGlowingBalls(const Shading &c, const RayStream &in);

} // namespace odraz
