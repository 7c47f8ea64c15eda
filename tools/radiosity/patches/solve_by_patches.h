// Solves a model between patches, with the stages that light the film's hall.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// Fills task.solution and task.report. Returns the system, for programs that measure it. Throws
// std::runtime_error, ModelError.
std::unique_ptr<PatchSystem> solveByPatches(SolveTask &task, const Gl &gl);

} // namespace odraz::radiosity
