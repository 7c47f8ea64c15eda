// A model while it is solved: the input and the results that both methods share.
#pragma once

#include "tools/radiosity/divide/element_reflectance.h"
#include "tools/radiosity/divide/regions.h"
#include "tools/radiosity/solution/solve_settings.h"

namespace odraz::radiosity {

enum class SolveStep { kDividing, kFormFactors, kDirectLight, kSolving, kFinalRays };
inline constexpr int kSolveSteps = 5;
inline constexpr const char *kStepNames[] = {"dividing", "form factors", "direct light", "solving",
                                             "final rays"};
static_assert(std::size(kStepNames) == kSolveSteps && (int)SolveStep::kFinalRays == kSolveSteps - 1);

// All results except light.
struct SolveReport {
    bool complete = true;             // all rows and sweeps are done; false: stopped early
    int rows = 0;                     // number of sites' or patches' rows found
    int sweeps = 0;                   // number of sweeps or bounces
    float residual = 0;               // after the last sweep
    double seconds[kSolveSteps] = {}; // processor time of each step
    std::vector<std::string> notes;   // messages for the user, one line each

    // By rays
    int sites = 0;
    size_t raysFromSite = 0; // mean number of rays
    // Between patches
    int patches = 0;
    int shots = 0; // if above 0, `residual` is the share of light not yet shot
};

struct SolveTask {
    const Mesh &mesh;
    SolveSettings settings; // the positions of its lamps are relative to Mesh::origin
    Workers &workers;       // must not watch an abort flag
    const int *stop;        // a value other than 0 ends the run early, with the light found so far
    const SolveProgress &progress;

    Regions regions;             // the mesh as charts, divided into cells of cellSide()
    ElementReflectance pictured; // the reflectance of materials with pictures
    Solution solution;           // both methods fill its cells, texels and light
    SolveReport report;

    // Joins triangles to regions, and sets the charts' reflectance and emission. Throws ModelError.
    SolveTask(const Mesh &mesh, const SolveSettings &settings, Workers &workers, const int *stop,
              const SolveProgress &progress);

    // Reports progress.
    void show(SolveStep step, float done, float residual = -1) const;
    // Adds the processor time since the last call to a step.
    void lap(SolveStep step);
    bool stopped() const { return __atomic_load_n(stop, __ATOMIC_RELAXED) != 0; }
    // Sets the solution's geometry, and the reflectance of cells and charts whose material has a picture.
    void setGeometry(const std::vector<Cell> &cells, const std::vector<Texel> &texels);
    // The share of solving that is done, 0 .. 1: the residual on a logarithmic scale.
    float solvedShare(float residual);

private:
    double lastLap;           // processor time at the last lap, seconds
    double firstResidual = 0; // logarithm of the first residual; 0: none yet
};

// The side of a cell, in the model's units.
double cellSide(const Mesh &mesh, const SolveSettings &settings);

// Throws std::runtime_error because `bytes` are needed and `most` are allowed. `remedy` names what to change.
[[noreturn]] void refuseMemory(size_t bytes, size_t most, const char *remedy);

} // namespace odraz::radiosity
