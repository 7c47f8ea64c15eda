// Direct light between patches, separated by material, for solutions with other power of the lamps.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// The shares of a system's direct light, to which nothing was added yet. If several materials emit, the light
// of each is found again for the final texels.
DirectShares lampShares(const SolveTask &task, PatchSystem &patches);

// Adds the direct light from outside: of the sky, suns and balls.
void addOutside(DirectShares &shares, const SolveTask &task, const PatchSystem &patches);

} // namespace odraz::radiosity
