#include "tools/radiosity/patches/patch_solver.h"

#include "tools/radiosity/patches/shooting.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>

namespace odraz::radiosity {

static constexpr int kMostSweeps = 10000;

void PatchSolver::makeSystem() {
    System &system = r.system;
    if (!fillSystem(r, m, p.arena, task.workers))
        refuseMemory(p.arena, (size_t)m.patchCount * kSolveBlock * 4 * sizeof(float));
    for (size_t i = 0; i < (size_t)m.patchCount; ++i)
        for (size_t k = 0; k < 9; ++k)
            if (k % 4) system.reflectance[i * (size_t)system.columns + k] = 0;
}

void PatchSolver::solveBounces() {
    makeSystem();
    System &system = r.system;
    std::vector<float> seen; // the lamps' light found by hemicubes
    if (!s.analytic) seen = p.lampsSeen(task.solution.emits, task.workers);
    for (size_t i = 0; i < seen.size(); ++i) system.direct[i] += seen[i];
    s.bounces < 0 ? solveToResidual() : countBounces();
    findIndirect(system, task.workers);
    for (size_t i = 0; i < seen.size(); ++i) system.indirect[i] += seen[i];
    spreadLight(r, m, task.workers);
    settleLight(r, m, task.workers);
}

void PatchSolver::shootLight() {
    makeSystem();
    System &system = r.system;
    auto count = (size_t)m.patchCount;
    std::vector<Rgb> emits(count), direct(count);
    for (size_t i = 0; i < count; ++i) {
        direct[i] = p.colourIn(system.direct, (int)i);
        if (!s.analytic) emits[i] = task.solution.emits[(size_t)m.patches[i].chart];
    }
    // A quarter of the shots is for the lamps; with the others each block of patches shoots about three times
    Shooting shooting(m, blocksOfPatches(m, emits, std::max(s.shots / 4, 1)), emits, std::move(direct));
    HemicubeShooter shooter(gl, m, s.hemicube);
    for (int most; (most = s.shots - report.shots) > 0 && shooting.left() > (double)s.residual;) {
        if (task.stopped()) report.whole = false;
        int shot = report.whole ? shooter.shoot(shooting, most, task.workers) : 0;
        if (shot == 0) break;
        report.shots += shot;
        task.show(SolveStep::kSolving, (float)report.shots / (float)s.shots, (float)shooting.left());
    }
    report.residual = (float)shooting.left();
    Rgb ambient = shooting.ambient();
    r.factors.rows = takeOrRefuse<Row>(p.arena, count);
    for (size_t i = 0; i < count; ++i) {
        p.setColour(system.indirect, (int)i, shooting.arrives()[i] + ambient);
        r.factors.rows[i].known = m.patches[i].share > 0; // hidden patches get their neighbours' light
    }
    spreadLight(r, m, task.workers);
    settleLight(r, m, task.workers);
}

void PatchSolver::countBounces() {
    for (Progress progress = progressOf(SolveStep::kSolving); report.sweeps < s.bounces;
         progress((float)report.sweeps / (float)s.bounces)) {
        bounce(r.system, task.workers);
        ++report.sweeps;
        watch(r.system.radiosity);
    }
}

void PatchSolver::solveToResidual() {
    report.residual = kInfinity; // in case it is stopped before the first sweep
    task.workers.abort = task.stop;
    report.sweeps =
        odraz::solve(r.system, task.workers, s.residual, kMostSweeps,
                     {[](float residual, void *own) { ((PatchSolver *)own)->afterSweep(residual); }, this});
    task.workers.abort = &kNever;
    if (!report.whole || report.residual <= s.residual || !task.stopped()) return;
    report.whole = false;
    saveState();
}

void PatchSolver::afterSweep(float residual) {
    report.residual = residual;
    task.show(SolveStep::kSolving, task.solvedShare(residual), residual);
    // There is one block, whose radiosities solve() stores there
    watch(r.system.indirect);
}

} // namespace odraz::radiosity
