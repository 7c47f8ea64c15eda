// The light that arrives at a run of hits: from all around, and from every light by itself.
//
// Lights are tried for all of a run at once, by rays from the light, dimmed by glass. Phong's highlights;
// cosines are clamped.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Fills run.diffuse, highlight and states.
void illuminate(const Context &c, const RayStream &in, Run &run);

} // namespace odraz
