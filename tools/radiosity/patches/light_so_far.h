// The light of a solution between patches while it is being solved.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// The light of each texel: direct light and, if `radiosity` (of patches, as in System) is not null, reflected
// light. Call it on the thread that solves.
std::vector<Rgb> lightSoFar(const SolveTask &task, const PatchSystem &patches, const float *radiosity);

} // namespace odraz::radiosity
