// The light of a solution between patches that is still being solved.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// The light of each texel: direct light and, if the patches' radiosities are given (as in System), what they
// reflect. Call it on the thread that solves.
std::vector<Rgb> lightSoFar(const SolveTask &task, const PatchSystem &patches, const float *radiosity);

} // namespace odraz::radiosity
