// Direct light between patches as shares, for solutions with other power of the lamps.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// From a system's direct light, to which nothing else was added yet. Lamps of several materials are looked at
// again, from the final texels.
DirectShares lampShares(const SolveTask &task, PatchSystem &patches);

// Adds what direct light has besides that of lamps: of the sky, suns and balls.
void addOutside(DirectShares &shares, const SolveTask &task, const PatchSystem &patches);

} // namespace odraz::radiosity
