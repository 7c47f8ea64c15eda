// Stores patches and elements as arrays of a file, for solutions with other materials.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

void savePatches(const Model &model, std::string &to);

// Fills the model of a system. Throws std::runtime_error if the arrays do not fit, or if memory is short.
void restorePatches(const PreparedSolve &prepared, const Regions &regions, PatchSystem &patches);

} // namespace odraz::radiosity
