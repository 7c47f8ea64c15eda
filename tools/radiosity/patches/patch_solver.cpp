#include "tools/radiosity/patches/patch_solver.h"

#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>

namespace odraz::radiosity {

// Whether any patch sees the back of a surface; about 500 patches are checked. If none does, hemicubes need
// not draw backs.
static bool seesBacks(const Model &m, const Mesh &mesh) {
    static constexpr int kPlaces = 500, kAround = 96;
    RayTree tree(cornersOf(mesh));
    for (int i = 0, every = std::max(1, m.patchCount / kPlaces); i < m.patchCount; i += every) {
        const Patch &p = m.patches[i];
        const Chart &c = m.charts[p.chart];
        for (int k = 0; p.share > 0 && k < kAround; ++k) {
            float up = 1 - ((float)k + 0.5f) / kAround, out = std::sqrt(1 - up * up),
                  turn = 2.3999632f * (float)k;
            Vec3 d = c.u * (out * std::cos(turn)) + c.v * (out * std::sin(turn)) + c.n * up;
            if (tree.nearest(p.p + c.n * c.off(), d).back) return true;
        }
    }
    return false;
}

void PatchSolver::run() {
    report.whole = true;
    divide();
    task.lap(SolveStep::kDividing);
    findDirectLight();
    watch(nullptr);
    task.lap(SolveStep::kDirectLight);
    if (s.shots > 0) {
        shootLight();
    } else {
        findRows();
        task.lap(SolveStep::kFormFactors);
        solveBounces();
    }
    fillSolution();
    task.lap(SolveStep::kSolving);
}

Progress PatchSolver::progressOf(SolveStep which) {
    step = which;
    return {[](float done, void *own) {
                auto &solver = *(PatchSolver *)own;
                solver.task.show(solver.step, done);
            },
            this};
}

void PatchSolver::divide() {
    Progress progress = progressOf(SolveStep::kDividing);
    progress(0);
    fillModel(m, task.regions);
    findLights();
    p.scene->add(Material{});
    poseFacets(m, *p.scene);
    p.scene->finish();
    progress(0.5f);
    int levels = s.adaptive ? kDivided : 0;
    refuseTooMany(levels);
    if (!m.divide(*p.scene, p.arena, task.workers, cellsOfPatch(), levels))
        refuseMemory(p.arena, texelBytes((size_t)m.texelRoom));
    m.solid = !seesBacks(m, task.mesh);
    findPictured(report.notes);
    for (int i = 0; i < m.patchCount; ++i)
        m.patches[i].reflects = task.solution.reflects[(size_t)m.patches[i].chart];
    task.pictured.toPatches(m);
    report.patches = m.patchCount;
    progress(1);
}

int PatchSolver::cellsOfPatch() const {
    // Hemicubes take longer in models of many polygons, so these get fewer
    double patch =
        s.patch > 0 ? s.patch : areaOf(task.mesh) / std::clamp(6000. * 2000 / m.facetCount, 400., 6000.);
    return (int)std::clamp(std::sqrt(patch) / cellSide(task.mesh, s) + 0.5, 1., (double)kMaxAcross);
}

void PatchSolver::findPictured(std::vector<std::string> &notes) {
    task.findPictured({m.charts, (size_t)m.chartCount}, {m.cells, (size_t)m.cellCount}, notes);
}

size_t PatchSolver::texelBytes(size_t texels) {
    return texels * (sizeof(Texel) + sizeof(Cell) + 6 * sizeof(Tie) + 16);
}

void PatchSolver::refuseTooMany(int levels) {
    double texels = 0;
    for (int i = 0; i < m.chartCount; ++i) texels += m.charts[i].texels();
    texels *= (4 << 2 * levels) / 3;
    size_t least = texelBytes((size_t)(texels / 2));
    if (least > s.memory) refuseMemory(p.arena, least);
    if (texels * 1.5 > INT_MAX)
        throw std::runtime_error("there are too many elements: make --element larger");
}

void PatchSolver::fillGeometry() {
    Solution &to = task.solution;
    to.charts.assign(m.charts, m.charts + m.chartCount);
    to.facets.assign(m.facets, m.facets + m.facetCount);
    to.cells.assign(m.cells, m.cells + m.cellCount);
    to.texels.assign(m.texels, m.texels + m.texelCount);
}

void PatchSolver::fillSolution() {
    fillGeometry();
    std::vector<Rgb> &light = task.solution.light;
    light.resize((size_t)m.texelCount);
    for (size_t t = 0; t < light.size(); ++t) light[t] = {p.light[0][t], p.light[1][t], p.light[2][t]};
}

void PatchSolver::watch(const float *radiosity) {
    if (!task.watched()) return;
    fillGeometry();
    task.solution.light = lightSoFar(radiosity);
    s.watcher(task.solution, radiosity);
}

std::unique_ptr<PatchSystem> solveByPatches(SolveTask &task, const Gl &gl) {
    auto p = std::make_unique<PatchSystem>(task.settings.memory);
    PatchSolver solver(task, *p, gl);
    solver.run();
    if (task.progress) task.progress(nullptr, 1, task.report.residual);
    return p;
}

} // namespace odraz::radiosity
