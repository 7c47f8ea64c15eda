#include "tools/radiosity/patches/solve_by_patches.h"

#include "tools/common/machine.h"
#include "tools/radiosity/patches/kept_patches.h"
#include "tools/radiosity/patches/lamp_shares.h"
#include "tools/radiosity/patches/lamps.h"
#include "tools/radiosity/patches/light_so_far.h"
#include "tools/radiosity/patches/patch_rows.h"
#include "tools/radiosity/patches/sees_backs.h"
#include "tools/radiosity/patches/shooting.h"
#include "tools/radiosity/patches/sky_light.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>

namespace odraz {

namespace {

constexpr int kSkyRays = 1024; // from each texel
constexpr int kMostSweeps = 10000;

// Runs the stages. Finding form factors and solving may be cut short; the others always run to their end.
class PatchSolver {
public:
    PatchSolver(SolveTask &task, PatchSystem &p, const Gl &gl)
        : task(task), s(task.settings), report(task.report), p(p), m(*p.model), r(p.radiosity), gl(gl),
          abort(task.workers.abort) {
        task.workers.abort = &kNever;
    }
    PatchSolver(const PatchSolver &) = delete;
    ~PatchSolver() { task.workers.abort = abort; }

    void run() {
        report.whole = true;
        divide();
        task.lap(SolveStep::kDividing);
        findDirectLight();
        watch(nullptr);
        task.lap(SolveStep::kDirectLight);
        if (s.shots > 0) {
            shootLight();
        } else {
            findPatchRows(task, p, gl);
            task.lap(SolveStep::kFormFactors);
            solveBounces();
        }
        fillSolution();
        task.lap(SolveStep::kSolving);
        if (s.keepRows && report.whole) keepRows();
    }

    // Solves with kept rows and direct light.
    void relight() {
        restorePatches(*task.prepared, task.regions, p);
        for (int i = 0; i < m.patchCount; ++i)
            m.patches[i].reflects = task.solution.reflects[(size_t)m.patches[i].chart];
        report.patches = m.patchCount;
        task.lap(SolveStep::kDividing);
        const DirectShares &shares = task.prepared->direct;
        s.analytic = !shares.seen;
        r.bases.skyCount = 3;
        takePlanes();
        std::vector<Rgb> light = shares.light(task.emitted(), (size_t)m.texelCount);
        for (size_t t = 0; t < light.size(); ++t)
            r.direct[0][t] = light[t].x, r.direct[1][t] = light[t].y, r.direct[2][t] = light[t].z;
        task.lap(SolveStep::kDirectLight);
        findPatchRows(task, p, gl);
        task.lap(SolveStep::kFormFactors);
        solveBounces();
        fillSolution();
        task.lap(SolveStep::kSolving);
    }

private:
    SolveTask &task;
    SolveSettings &s;
    SolveReport &report;
    PatchSystem &p;
    Model &m;
    Radiosity &r;
    const Gl &gl;
    const int *abort; // what the workers watched before
    SolveStep step = SolveStep::kDividing;
    DirectShares shares; // for keepRows()

    void keepRows() {
        std::string prepared;
        if (task.preparable()) {
            prepared =
                task.prepare(shares, {m.charts, (size_t)m.chartCount}, {m.facets, (size_t)m.facetCount});
            savePatches(m, prepared);
        }
        s.keepRows(savedPatchRows(p), std::move(prepared));
    }

    Progress tell(SolveStep which) {
        step = which;
        return {[](float done, void *own) {
                    auto &solver = *(PatchSolver *)own;
                    solver.task.tell(solver.step, done);
                },
                this};
    }

    // --- Patches and elements ---

    void divide() {
        Progress progress = tell(SolveStep::kDividing);
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

    // The number of cells along a side of a patch.
    int cellsOfPatch() const {
        // A hemicube of many polygons takes longer, so then there are fewer
        double patch =
            s.patch > 0 ? s.patch : areaOf(task.mesh) / std::clamp(6000. * 2000 / m.facetCount, 400., 6000.);
        return (int)std::clamp(std::sqrt(patch) / cellSide(task.mesh, s) + 0.5, 1., (double)kMaxAcross);
    }

    void findPictured(std::vector<std::string> &notes) {
        task.findPictured({m.charts, (size_t)m.chartCount}, {m.cells, (size_t)m.cellCount}, notes);
    }

    static size_t texelBytes(size_t texels) {
        return texels * (sizeof(Texel) + sizeof(Cell) + 6 * sizeof(Tie) + 16);
    }

    void refuseTooMany(int levels) {
        double texels = 0;
        for (int i = 0; i < m.chartCount; ++i) texels += m.charts[i].texels();
        texels *= (4 << 2 * levels) / 3;
        size_t least = texelBytes((size_t)(texels / 2));
        if (least > s.memory) refuseMemory(p.arena, least);
        if (texels * 1.5 > INT_MAX)
            throw std::runtime_error("there are too many elements: make --element larger");
    }

    // --- Direct light ---

    // Prepares direct light: by shadow rays from the texels or, where that takes too long, by hemicubes.
    void findLights() {
        p.glows = findLamps(task.mesh, task.regions, m, s.lampSamples);
        report.lamps = p.glows.size();
        const Surroundings &around = s.surroundings;
        if (p.glows.size() > kManyLamps) s.analytic = false;
        r.bases.skyCount = 3;
        // Suns and lamps are separate bases until their light has arrived
        Vec3 middle = toFloat(task.mesh.middle());
        float far = (float)(1000 * task.mesh.size());
        for (const Sun &sun : around.suns) r.bases.suns[r.bases.sunCount++] = middle + sun.towards * far;
        for (const BallLamp &lamp : around.lamps)
            r.bases.lamps[r.bases.lampCount++] = {lamp.centre, lamp.radius, -1};
        if (!s.analytic) return;
        r.bases.glows = p.glows.data();
        r.bases.glowCount = (int)p.glows.size();
    }

    void findDirectLight() {
        RadiositySettings settings;
        settings.levels = s.adaptive ? kDivided : 0;
        settings.contrast = s.contrast;
        takePlanes();
        findDirect(r, m, *p.scene, settings, task.workers, tell(SolveStep::kDirectLight));
        std::vector<std::string> known; // notes by divide()
        if (s.adaptive) findPictured(known);
        bool keeps = s.keepRows && task.preparable();
        if (keeps) shares = lampShares(task, p);
        addOutsideLight();
        if (keeps) addOutside(shares, task, p);
    }

    void takePlanes() {
        size_t texels = (size_t)m.texelRoom + 8;
        for (int k = 3; k < r.bases.count(); ++k) r.direct[k] = takeOrRefuse<float>(p.arena, texels);
        for (int k = 0; k < 3; ++k) {
            r.direct[k] = takeOrRefuse<float>(p.arena, texels);
            p.light[k] = takeOrRefuse<float>(p.arena, texels);
            float *unused = takeOrRefuse<float>(p.arena, texels);
            for (int c = 0; c < 3; ++c) r.bounced[k][c] = k == c ? p.light[k] : unused;
        }
    }

    // Adds the light of suns, lamps and sky to that of the model's own lamps.
    void addOutsideLight() {
        const Surroundings &around = s.surroundings;
        auto add = [&](int basis, const Rgb &light) {
            const float share[3] = {light.x, light.y, light.z};
            for (int k = 0; k < 3; ++k)
                for (int t = 0; t < m.texelCount; ++t) r.direct[k][t] += share[k] * r.direct[basis][t];
        };
        for (size_t i = 0; i < around.suns.size(); ++i)
            add(r.bases.firstSun() + (int)i, around.suns[i].light);
        for (size_t i = 0; i < around.lamps.size(); ++i)
            add(r.bases.firstLamp() + (int)i, around.lamps[i].radiance);
        r.bases.sunCount = r.bases.lampCount = 0;
        if (around.sky.width) addSky(m, *p.scene, around.sky, kSkyRays, task.workers, r.direct);
    }

    // --- Bounces ---

    // The reflectance of patches, and the direct light that arrives there. The right-hand sides are separate
    // colours: red light has no green.
    void makeSystem() {
        System &system = r.system;
        if (!fillSystem(r, m, p.arena, task.workers))
            refuseMemory(p.arena, (size_t)m.patchCount * kSolveBlock * 4 * sizeof(float));
        for (size_t i = 0; i < (size_t)m.patchCount; ++i)
            for (size_t k = 0; k < 9; ++k)
                if (k % 4) system.reflectance[i * (size_t)system.columns + k] = 0;
    }

    // Solves for the light that patches receive and reflect, and from it the texels' reflected light.
    void solveBounces() {
        makeSystem();
        System &system = r.system;
        size_t columns = (size_t)system.columns, all = (size_t)m.patchCount * columns;
        const float *seen = s.analytic ? nullptr : lightOfSeenLamps();
        for (size_t i = 0; seen && i < all; ++i) system.direct[i] += seen[i];
        s.bounces < 0 ? solveToResidual() : countBounces();
        findIndirect(system, task.workers);
        for (size_t i = 0; seen && i < all; ++i) system.indirect[i] += seen[i];
        spreadLight(r, m, task.workers);
        settleLight(r, m, task.workers);
    }

    // Shoots light instead of solving with rows.
    void shootLight() {
        makeSystem();
        System &system = r.system;
        auto count = (size_t)m.patchCount, columns = (size_t)system.columns;
        std::vector<Rgb> emits(count), direct(count);
        for (size_t i = 0; i < count; ++i) {
            const float *arrives = system.direct + i * columns;
            direct[i] = {arrives[0], arrives[4], arrives[8]};
            if (!s.analytic) emits[i] = task.solution.emits[(size_t)m.patches[i].chart];
        }
        // A quarter of the shots for the lamps; the others let every block of patches shoot about three times
        Shooting shooting(m, blocksOfPatches(m, emits, std::max(s.shots / 4, 1)), emits, std::move(direct));
        HemicubeShooter shooter(gl, m, s.hemicube, s.turn);
        for (int most; (most = s.shots - report.shots) > 0 && shooting.left() > (double)s.residual;) {
            if (task.stopped()) report.whole = false;
            int shot = report.whole ? shooter.shoot(shooting, most, task.workers) : 0;
            if (shot == 0) break;
            report.shots += shot;
            task.tell(SolveStep::kSolving, (float)report.shots / (float)s.shots, (float)shooting.left());
        }
        report.residual = (float)shooting.left();
        Rgb ambient = shooting.ambient();
        r.factors.rows = takeOrRefuse<Row>(p.arena, count);
        for (size_t i = 0; i < count; ++i) {
            Rgb arrives = shooting.arrives()[i] + ambient;
            float *to = system.indirect + i * columns;
            to[0] = arrives.x, to[4] = arrives.y, to[8] = arrives.z;
            r.factors.rows[i].known = m.patches[i].share > 0; // hidden patches get their neighbours' light
        }
        spreadLight(r, m, task.workers);
        settleLight(r, m, task.workers);
    }

    // The light of lamps that hemicubes find, for each patch and column.
    const float *lightOfSeenLamps() {
        const System &system = r.system;
        size_t columns = (size_t)system.columns, all = (size_t)m.patchCount * columns;
        auto *seen = takeOrRefuse<float>(p.arena, all), *lamps = takeOrRefuse<float>(p.arena, all);
        for (int i = 0; i < m.patchCount; ++i) {
            Rgb e = task.solution.emits[(size_t)m.patches[i].chart];
            float *to = lamps + (size_t)i * columns;
            to[0] = e.x, to[4] = e.y, to[8] = e.z;
        }
        findIndirect(r.factors, m.patchCount, system.columns, lamps, seen, task.workers);
        return seen;
    }

    void countBounces() {
        for (Progress progress = tell(SolveStep::kSolving); report.sweeps < s.bounces;
             progress((float)report.sweeps / (float)s.bounces)) {
            bounce(r.system, task.workers);
            ++report.sweeps;
            watch(r.system.radiosity);
        }
    }

    void solveToResidual() {
        report.residual = kInfinity; // it may be stopped before the first sweep
        task.workers.abort = task.stop;
        report.sweeps = odraz::solve(
            r.system, task.workers, s.residual, kMostSweeps,
            {[](float residual, void *own) { ((PatchSolver *)own)->afterSweep(residual); }, this});
        task.workers.abort = &kNever;
        if (!report.whole || report.residual <= s.residual || !task.stopped()) return;
        report.whole = false;
        keepPatchRows(task, p);
    }

    void afterSweep(float residual) {
        report.residual = residual;
        task.tell(SolveStep::kSolving, task.solvedShare(residual), residual);
        // There is one block, whose radiosities solve() keeps there
        watch(r.system.indirect);
    }

    // --- The solution ---

    void fillGeometry() {
        Solution &to = task.solution;
        to.charts.assign(m.charts, m.charts + m.chartCount);
        to.facets.assign(m.facets, m.facets + m.facetCount);
        to.cells.assign(m.cells, m.cells + m.cellCount);
        to.texels.assign(m.texels, m.texels + m.texelCount);
    }

    void fillSolution() {
        fillGeometry();
        std::vector<Rgb> &light = task.solution.light;
        light.resize((size_t)m.texelCount);
        for (size_t t = 0; t < light.size(); ++t) light[t] = {p.light[0][t], p.light[1][t], p.light[2][t]};
    }

    // Shows the light so far; without radiosities only direct light.
    void watch(const float *radiosity) {
        if (!task.watched()) return;
        fillGeometry();
        task.solution.light = lightSoFar(task, p, radiosity);
        s.watcher(task.solution, radiosity);
    }
};

} // namespace

std::unique_ptr<PatchSystem> solveByPatches(SolveTask &task, const Gl &gl) {
    auto p = std::make_unique<PatchSystem>(task.settings.memory);
    PatchSolver solver(task, *p, gl);
    task.prepared ? solver.relight() : solver.run();
    if (task.progress) task.progress(nullptr, 1, task.report.residual);
    return p;
}

} // namespace odraz
