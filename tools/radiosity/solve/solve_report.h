// The summary that `radiosity solve` prints at its end.
#pragma once

#include "tools/radiosity/solve/solve.h"

namespace odraz::radiosity {

void printReport(const Mesh &mesh, const Solved &solved, const SolveSettings &settings);
// The same for kept rows, without numbers that take time to count.
void printRelit(const Solved &solved, const SolveSettings &settings);

} // namespace odraz::radiosity
