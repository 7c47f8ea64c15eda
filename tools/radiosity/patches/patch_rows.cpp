#include "tools/radiosity/patches/patch_solver.h"

#include "tools/common/clock.h"
#include "tools/radiosity/patches/row_finder.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>

namespace odraz::radiosity {

// Marks each patch whose row is needed: it reflects, or emits light that hemicubes find.
const uint8_t *PatchSolver::findLit() {
    auto *lit = takeOrRefuse<uint8_t>(p.arena, (size_t)m.patchCount);
    for (int i = 0; i < m.patchCount; ++i) {
        const Patch &patch = m.patches[i];
        bool seen = !s.analytic && maxComponent(task.solution.emits[(size_t)patch.chart]) > 0;
        lit[i] = maxComponent(patch.reflects) > 0 || seen ? kReflects : kUnlit;
    }
    return lit;
}

void PatchSolver::findRows() {
    const uint8_t *lit = findLit();
    if (!s.resumed.empty()) restoreRows();
    report.whole = true;
    RowFinder find = s.findRows;
    if (!find) find = rowsByHemicubes(gl, s.hemicube);
    saved = common::wallSeconds();
    auto progress = [](float done, void *own) {
        auto &solver = *(PatchSolver *)own;
        solver.task.show(SolveStep::kFormFactors, done);
        if (common::wallSeconds() - solver.saved < solver.s.keepEvery) return;
        solver.saveState();
        solver.saved = common::wallSeconds();
    };
    task.workers.abort = task.stop;
    report.whole = find(m, *p.scene, lit, task.workers, p.arena, r.factors, {progress, this});
    task.workers.abort = &kNever;
    if (!report.whole) saveState();
    for (int i = 0; i < m.patchCount; ++i) report.rows += r.factors.rows[i].known;
}

} // namespace odraz::radiosity
