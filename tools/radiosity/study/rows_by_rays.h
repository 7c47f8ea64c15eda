// Rows by rays instead of hemicubes, for models whose hemicubes take too long. The later steps are the same.
#pragma once

#include "tools/radiosity/solution/solve_settings.h"

namespace odraz::radiosity {

// Every patch sends out `rays` rays by the cosine law, from its middle or a quarter of them from near each
// of its corners; each counts the same.
RowFinder rowsByRays(int rays, bool atCorners = false);

} // namespace odraz::radiosity
