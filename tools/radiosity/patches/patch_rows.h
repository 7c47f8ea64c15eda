// Finds the rows of patches, saves them at intervals, and resumes from saved ones.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// Fills radiosity.factors, starting with the rows of task.settings.resumed. Sets report.whole to whether all
// rows were found before a stop, and report.rows to their number. Sets workers.abort and restores it.
void findPatchRows(SolveTask &task, PatchSystem &patches, const Gl &gl);

// The rows found so far, in the form of settings.resumed.
std::string savedPatchRows(const PatchSystem &patches);
// Calls settings.keep with them.
void keepPatchRows(const SolveTask &task, const PatchSystem &patches);

} // namespace odraz::radiosity
