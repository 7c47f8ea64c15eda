// The light that arrives at a run of hits: ambient light, and the light of every Light.
//
// The shadow rays of a run to one light are traced together, as a beam from that light; glass dims them.
// Highlights are Phong's. Cosines are clamped.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Fills in `diffuse`, `highlight` and `states` of a run.
void illuminate(const Shading &c, Run &run);

} // namespace odraz
