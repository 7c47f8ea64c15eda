// Light is linear: if all lamps change by the same factor and nothing else does, a solution is scaled instead
// of solved again.
#pragma once

#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// Scales the light of a solution to these materials. Returns false, without a change, if reflectance differs
// from the solution's, if the lamps do not all change by the same factors of red, green and blue, or if there
// is other light. A solution by rays has one residual for all colours, so these must have the same factor.
bool scaleLight(Solution &solution, const Mesh &materials, const PreparedSolve &prepared,
                const SolveSettings &settings);

} // namespace odraz::radiosity
