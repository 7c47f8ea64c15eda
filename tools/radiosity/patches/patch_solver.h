// The stages of a solution between patches, as solveByPatches() runs them.
#pragma once

#include "tools/radiosity/patches/patch_system.h"

namespace odraz::radiosity {

// Finding form factors and solving may be stopped early; the other stages always run to their end.
class PatchSolver {
public:
    PatchSolver(SolveTask &task, PatchSystem &p, const Gl &gl)
        : task(task), s(task.settings), report(task.report), p(p), m(*p.model), r(p.radiosity), gl(gl),
          abort(task.workers.abort) {
        task.workers.abort = &kNever;
    }
    PatchSolver(const PatchSolver &) = delete;
    ~PatchSolver() { task.workers.abort = abort; }

    void run();

private:
    SolveTask &task;
    SolveSettings &s;
    SolveReport &report;
    PatchSystem &p;
    Model &m;
    Radiosity &r;
    const Gl &gl;
    const int *abort; // the workers' former abort flag
    SolveStep step = SolveStep::kDividing;
    double saved = 0; // when the rows found so far were last saved

    Progress progressOf(SolveStep which);

    // --- Kept files --- Fills the rows from settings.resumed, saves those found so far in the same form, and
    // calls settings.keep with them.
    void restoreRows();
    void saveState() const;

    // --- Patches and elements ---
    void divide();
    // The number of cells along a side of a patch.
    int cellsOfPatch() const;
    void findPictured(std::vector<std::string> &notes);
    static size_t texelBytes(size_t texels);
    void refuseTooMany(int levels);

    // --- Direct light --- Prepares direct light: by shadow rays from the texels or, if that takes too long,
    // by hemicubes.
    void findLights();
    void findDirectLight();
    void takePlanes();
    // Adds the light of suns, lamps and sky to that of the model's own lamps.
    void addOutsideLight();
    // Adds the sky's light by rays through a grid over the cosine-weighted hemisphere, a quarter of them from
    // each of a texel's four places; the grid is rotated differently at every texel.
    void addSky();

    // --- Rows --- Finds the missing rows, and saves them at intervals. Sets report.whole to whether all were
    // found before a stop, and report.rows to their number.
    void findRows();
    const uint8_t *findLit();

    // --- Bounces --- Sets the reflectance of patches and the direct light that arrives there. Each
    // right-hand side is a pure red, green or blue.
    void makeSystem();
    // Solves for the light that patches receive and reflect, and from it the texels' reflected light.
    void solveBounces();
    // Shoots light instead of solving with rows.
    void shootLight();
    void countBounces();
    void solveToResidual();
    void afterSweep(float residual);

    // --- The solution ---
    void fillGeometry();
    void fillSolution();
    // Shows the light so far to the watcher; only direct light if `radiosity` (of patches, as in System) is
    // null.
    void watch(const float *radiosity);
    std::vector<Rgb> lightSoFar(const float *radiosity) const;
};

} // namespace odraz::radiosity
