// What rays add to their samples.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// What a run shows, lit as it is, and what marks it leaves.
void addShown(const Context &c, const RayStream &in, const Run &run);

// The sky, for a run that meets nothing.
void addSky(const Context &c, const RayStream &in, const Run &run);

} // namespace odraz
