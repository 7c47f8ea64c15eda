// How rays go on: reflected and refracted.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Appends to `out` what a run reflects and refracts, where its share of the picture counts.
void scatter(const Context &c, const RayStream &in, const Run &run, RayStream &out);

} // namespace odraz
