// A RowFinder that uses hemicubes, and helpers for those that find one row at a time.
#pragma once

#include "tools/radiosity/patches/odd_hemicube.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <vector>

namespace odraz::radiosity {

// Finds rows by hemicubes that OpenGL draws, of `px` pixels, `each` for a patch, at `eyeOf` or in the patch's
// middle. Refuses at once if the estimate does not fit the arena.
RowFinder rowsByHemicubes(const Gl &gl, int px, int each = 1, EyeOf eyeOf = {});

// A row of those finders.
struct FoundRow {
    std::vector<Link> links;
    bool known;
};
void keepRows(const std::vector<FoundRow> &rows, Arena &arena, FormFactors &factors);
// The patch at a point of a chart.
uint32_t patchAt(const Model &model, int chart, Vec3 at);

} // namespace odraz::radiosity
