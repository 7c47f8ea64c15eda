// Solves a model by rays from every element.
#pragma once

#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// Fills task.solution and task.report. Throws std::runtime_error.
void solveByRays(SolveTask &task);

} // namespace odraz::radiosity
