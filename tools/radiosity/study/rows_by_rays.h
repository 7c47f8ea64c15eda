// Rows by rays instead of hemicubes, for models whose hemicubes take too long: what happens after the rows
// are found does not depend on how.
#pragma once

#include "tools/radiosity/solution/solve_settings.h"

namespace odraz {

// Every patch sends out so many rays by the cosine law; each counts the same.
RowFinder rowsByRays(int rays);

} // namespace odraz
