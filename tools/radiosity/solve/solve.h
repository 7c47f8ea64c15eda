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
    Vec3d away = {};                      // the model's distance from the origin, near which it was solved
    std::unique_ptr<PatchSystem> patches; // the system of patches; null if solved by rays
};

// Only hemicubes use OpenGL. Workers must not watch an abort flag. A value other than 0 in `stop` ends it
// early, with the light found so far. Throws ModelError, or std::runtime_error for other failures.
Solved solveModel(const Mesh &mesh, const SolveSettings &settings, const Gl &gl, Workers &workers,
                  const int *stop, const SolveProgress &progress);

// The same with kept rows and direct light, for other materials: `materials` has these, without polygons.
// `evenSky`: the kept light is an even sky's; `away` as in Solved.
Solved relightModel(const Mesh &materials, PreparedSolve prepared, bool evenSky, const Vec3d &away,
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

// The vector from the origin, where floats are most precise, to the model; zero if it is close enough. And
// the model, moved to the origin by that vector.
Vec3d offsetOf(const Mesh &mesh);
Mesh moved(const Mesh &mesh, const Vec3d &from);

// Throws std::runtime_error: a fresh solution would add an even sky, which kept rows do not have.
[[noreturn]] void refuseDark();

} // namespace odraz::radiosity
