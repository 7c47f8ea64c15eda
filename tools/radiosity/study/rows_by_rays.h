// Rows of patches by rays instead of hemicubes, for models whose hemicubes take too long. The later steps are
// the same.
#pragma once

#include "tools/radiosity/solution/solve_settings.h"

namespace odraz::radiosity {

// Every patch sends out `rays` rays by the cosine law, from its middle, or a quarter of them from near each
// corner. Each has the same weight.
RowFinder rowsByRays(int rays, bool atCorners = false);

} // namespace odraz::radiosity
