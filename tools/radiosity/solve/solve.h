// Solves a model by rays or between patches, for `radiosity solve` and for measuring programs.
#pragma once

#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/solution/solve_task.h"

namespace odraz::radiosity {

// Among the notes if a model is black.
inline constexpr char kDarkNote[] =
    "no light reaches the fronts of the polygons: try --two-sided, or another light";

struct Solved {
    Solution solution;
    SolveReport report;
    Surroundings surroundings;            // light from outside, as given, or an even sky
    std::unique_ptr<PatchSystem> patches; // null if solved by rays
};

// Solves a model. Only hemicubes use OpenGL. Workers must not watch an abort flag. A value other than 0 in
// `stop` ends the run early, with the light found so far. Throws ModelError or std::runtime_error.
Solved solveModel(const Mesh &mesh, const SolveSettings &settings, const Gl &gl, Workers &workers,
                  const int *stop, const SolveProgress &progress);

// Returns solve(). Puts the model's name before the text of a ModelError.
template <class Solve> auto solveNamed(const std::string &model, Solve &&solve) {
    try {
        return solve();
    } catch (const ModelError &e) {
        throw ModelError(model + ": " + e.what());
    }
}

} // namespace odraz::radiosity
