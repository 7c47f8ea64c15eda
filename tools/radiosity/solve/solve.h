// Solves a model by rays or between patches, for `radiosity solve` and for measuring programs.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

struct Solved {
    Solution solution;
    SolveReport report;
    Surroundings surroundings;            // light from outside: as given, or an even sky
    bool evenSky = false;                 // an even sky was added
    std::unique_ptr<PatchSystem> patches; // the system of patches; null if solved by rays
};

// Only hemicubes use OpenGL. Workers must not watch an abort flag. A value other than 0 in `stop` ends it
// early, with the light found so far. Throws ModelError, or std::runtime_error for other failures.
Solved solveModel(const Mesh &mesh, const SolveSettings &settings, const Gl &gl, Workers &workers,
                  const int *stop, const SolveProgress &progress);

// The same with kept rows and direct light, for other materials: `materials` has these and the model's place,
// without polygons. `evenSky`: the kept light is an even sky's.
Solved relightModel(const Mesh &materials, PreparedSolve prepared, bool evenSky,
                    const SolveSettings &settings, Workers &workers, const int *stop,
                    const SolveProgress &progress);

// Returns solve(). A ModelError gets the model's name.
template <class Solve> auto solveNamed(const std::string &model, Solve &&solve) {
    try {
        return solve();
    } catch (const ModelError &e) {
        throw ModelError(model + ": " + e.what());
    }
}

// Throws std::runtime_error: a fresh solution would add an even sky, which kept rows do not have.
[[noreturn]] void refuseDark();

} // namespace odraz::radiosity
