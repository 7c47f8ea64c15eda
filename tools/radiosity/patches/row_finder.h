// A RowFinder that uses hemicubes.
#pragma once

#include "tools/radiosity/patches/odd_hemicube.h"
#include "tools/radiosity/solution/solve_settings.h"

namespace odraz::radiosity {

// Finds rows by hemicubes that OpenGL draws, of `px` pixels, `each` for a patch, at `eyeOf` or in the patch's
// middle. Refuses at once if the estimate does not fit the arena.
RowFinder rowsByHemicubes(const Gl &gl, int px, int each = 1, EyeOf eyeOf = {});

} // namespace odraz::radiosity
