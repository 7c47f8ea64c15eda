// A RowFinder that uses hemicubes, and helpers for finders that work row by row.
#pragma once

#include "tools/radiosity/patches/odd_hemicube.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <vector>

namespace odraz::radiosity {

// Finds rows by hemicubes that OpenGL draws, of `px` pixels, `turns` for each patch. Another `turn` rotates
// all of them differently. Refuses at once if the estimate does not fit the arena.
// With `eyeOf` they do not stand in the patches' middles.
RowFinder rowsByHemicubes(const Gl &gl, int px, int turns, uint32_t turn, EyeOf eyeOf = {});

// The result of finders that find one row at a time.
struct FoundRow {
    std::vector<Link> links;
    bool known;
};
void keepRows(const std::vector<FoundRow> &rows, Arena &arena, FormFactors &factors);
// The patch at a place of a chart.
uint32_t patchAt(const Model &model, int chart, Vec3 at);

} // namespace odraz::radiosity
