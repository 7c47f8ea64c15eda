// Computes the surface points that rays hit, and the rays' weights there.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Fills in the members of a run from `p` to `weight`.
void arrive(const Shading &c, const RayStream &in, Run &run);

} // namespace odraz
