// Glowing balls in mirrors and through glass, drawn at least as large as a sample.
//
// A lamp's image in a mirror ball is smaller than the distance between samples, and many times brighter than
// white. Samples would hit or miss it by chance, and it would flicker. So balls that only glow add nothing to
// secondary rays that hit them; instead, their images are widened to the sample's width, and dimmed to match.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Adds the glowing balls that are in front of the hits of a stream's rays. (Where rays hit such balls
// themselves, contribute.cpp adds nothing.)
void addGlowingBalls(const Shading &c, const RayStream &in);

} // namespace odraz
