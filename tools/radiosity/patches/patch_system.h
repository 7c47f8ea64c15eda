// A solution between patches, as in the thesis: a hemicube at each patch gives its row of form factors, and
// sweeps over all patches find the light. The model has the form that the film's hemicubes need.
#pragma once

#include "tools/radiosity/patches/any_hemicube.h"
#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/solution/solve_task.h"
#include "tools/support/machine.h"

#include <memory>

namespace odraz::radiosity {

struct PatchSystem {
    std::unique_ptr<Model> model = std::make_unique<Model>(); // points into the lists below
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Patch> patches;
    FormFactorRows rows{0};
    // For each patch
    std::vector<Rgb> emits;  // emission that hemicubes see; black if shadow rays find it
    std::vector<Rgb> direct; // the light that arrives without a bounce

    // The radiosity of patches by direct light alone.
    std::vector<Rgb> reflectDirect() const;
    // A sweep over all patches: B = rho (D + F B). With `atOnce` new values are used in the same sweep
    // (Gauss-Seidel); otherwise a sweep is one bounce. Returns the residual: the sum of changes as a share of
    // the sum of reflectDirect(), for the colour with the largest share.
    float sweep(std::vector<Rgb> &radiosity, bool atOnce) const;
};

// Solves a model between patches. Fills task.solution and task.report. Returns the system, for programs that
// measure it. Throws std::runtime_error, ModelError.
std::unique_ptr<PatchSystem> solveByPatches(SolveTask &task, const Gl &gl);

} // namespace odraz::radiosity
