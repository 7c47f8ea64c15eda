// Secondary rays: reflected and refracted rays.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Appends the reflected and refracted rays of a run to `out` if their share of the picture is large enough.
void addSecondaryRays(const Shading &c, const RayStream &in, const Run &run, RayStream &out);

} // namespace odraz
