// Where rays arrive, and what is left of them there.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Fills in a run's places, from `p` to `weight`.
void arrive(const Context &c, const RayStream &in, Run &run);

} // namespace odraz
