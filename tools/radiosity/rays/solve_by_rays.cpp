#include "tools/radiosity/rays/ray_system.h"

#include "tools/common/clock.h"
#include "tools/radiosity/rays/lamp_rays.h"
#include "tools/radiosity/solution/solve_task.h"

#include <algorithm>

namespace odraz::radiosity {

namespace {

constexpr float kFirst = 0.25f; // the first rays take about this share of the time of all rays
// Tolerated relative error of the light that a site's rays and those of its neighbours find
constexpr float kError = 0.014f;
constexpr float kFinalShared = 0.1f; // kShared after the final gather
constexpr int kMostRaySweeps = 10000;

// Estimates the bytes that a solution needs, before any are allocated.
size_t memoryFor(const SolveTask &task) {
    const SolveSettings &s = task.settings;
    size_t charts = task.regions.charts.size(), texels = 0, cells = 0, sites = 0;
    for (const Chart &c : task.regions.charts) {
        bool small = c.across == 1 && c.down == 1;
        texels += (size_t)c.texels(), cells += (size_t)c.across * (size_t)c.down;
        sites += small ? 1 : (size_t)c.texels();
    }
    double first = s.rays > 0 ? s.rays : RaySystem::kLeastRays, sent = (double)sites * first;
    if (s.rays == 0)
        sent += std::max(sent, std::min((double)sites * RaySystem::kMostRays, RaySystem::kAllRays));
    size_t points = task.mesh.points.size(), triangles = task.mesh.triangles.size();
    return points * sizeof(Vec3d) + triangles * (sizeof(Triangle) + 40) + RayTree::bytesFor(triangles) +
           charts * (sizeof(Chart) + 2 * sizeof(Facet)) + cells * 2 * sizeof(Cell) +
           texels * (2 * sizeof(Texel) + 5 * sizeof(Rgb) + 24) + sites * 260 + (size_t)sent * 4;
}

// Solves for the light at the sites, step by step.
class RaySolver {
public:
    explicit RaySolver(SolveTask &task) : task(task) {}

    void run() {
        report.sites = (int)grid.sites.size();
        task.setGeometry(grid.cells, grid.texels);
        task.show(SolveStep::kDividing, 1);
        task.lap(SolveStep::kDividing);
        if (!s.saving.resumed.empty() && !system.restore(s.saving.resumed))
            throw std::runtime_error(
                "the saved state is damaged or belongs to another model: solve the model again");
        findFirstRows();
        findDirectLight();
        watch([&] {
            std::vector<Rgb> light = direct;
            grid.fill(light);
            return light;
        });
        if (s.rays == 0 && report.complete) refineRows();
        report.raysFromSite = system.rows.size() / std::max(grid.sites.size(), (size_t)1);
        solve();
        task.solution.light = lightOfTexels(kShared);
        if (s.finalRays > 0 && report.complete) finalGather();
        task.lap(SolveStep::kSolving);
    }

private:
    SolveTask &task;
    SolveSettings &s = task.settings;
    SolveReport &report = task.report;
    const LightGrid grid{task.mesh, task.regions, task.workers};
    RaySystem system{grid, s.surroundings, task.workers};
    double savedAt = common::wallSeconds(); // when rows were last saved
    std::vector<Rgb> direct;                // direct light of each texel
    std::vector<Rgb> directAtSites, reflects;

    // Lets the watcher see the light of texels that find() returns.
    template <class Find> void watch(const Find &find) {
        if (!s.watcher) return;
        s.watcher([&]() -> const Solution & {
            task.solution.light = find();
            return task.solution;
        });
    }

    void keep() {
        if (!s.saving.save) return;
        s.saving.save(system.saved());
        savedAt = common::wallSeconds();
    }
    bool keepIsDue() const { return common::wallSeconds() - savedAt > s.saving.seconds; }

    // Finds the missing rows for these numbers of rays. Reports progress in the range `from` .. `to`.
    void findRows(const std::vector<uint16_t> &rays, float from, float to) {
        size_t missing = system.setRays(rays), count = rays.size(), done = 0;
        size_t piece = std::clamp(count / 100, (size_t)256, (size_t)8192);
        for (size_t first = 0; first < count; first += piece) {
            size_t end = std::min(first + piece, count);
            task.show(SolveStep::kFormFactors,
                      from + (to - from) * (float)done / (float)std::max(missing, (size_t)1));
            bool stopped = task.stopped();
            if (stopped) report.complete = false;
            if (stopped || keepIsDue()) keep();
            if (!report.complete) return;
            for (size_t i = first; i < end; ++i) done += !system.found[i];
            system.findRows(first, end);
            report.rows = (int)end;
        }
        task.show(SolveStep::kFormFactors, to);
    }

    void findFirstRows() {
        auto rays = (uint16_t)(s.rays > 0 ? s.rays : RaySystem::kLeastRays);
        if (!system.refined)
            findRows(std::vector<uint16_t>(grid.sites.size(), rays), 0, s.rays > 0 ? 1 : kFirst);
        system.findsExcluded = false;
        task.lap(SolveStep::kFormFactors);
    }

    void findDirectLight() {
        task.show(SolveStep::kDirectLight, 0);
        LampRays lamps(task.mesh, task.regions, s.lampSamples);
        if (lamps.share() > kLargeLamps) { // the rows find their light better than shadow rays
            system.emits = task.solution.emits;
            lamps.clear();
        }
        direct = directLight(lamps, s.surroundings, grid, system.excluded, task.workers);
        directAtSites = system.meansOfPoints(direct);
        reflects = system.reflectance(task.solution);
        task.lap(SolveStep::kDirectLight);
        task.show(SolveStep::kDirectLight, 1);
    }

    // Estimates from a first solution how many rays each site needs, and finds these rows.
    void refineRows() {
        std::vector<uint16_t> rays(grid.sites.size());
        for (size_t i = 0; i < rays.size(); ++i) rays[i] = (uint16_t)system.rays(i);
        if (!system.refined) {
            system.solve(directAtSites, reflects, false, 0.01f, 100, [](float) { return true; });
            task.lap(SolveStep::kSolving);
            rays = system.raysFor(directAtSites, reflects, kError, kShared);
        }
        system.refined = true;
        findRows(rays, kFirst, 1);
        task.lap(SolveStep::kFormFactors);
    }

    void solve() {
        bool counted = s.bounces >= 0;
        auto afterSweep = [&](float residual) {
            report.residual = residual;
            if (report.complete && keepIsDue()) keep();
            task.show(SolveStep::kSolving, task.solvedShare(residual), residual);
            watch([&] { return lightOfTexels(kShared); });
            return !task.stopped();
        };
        report.sweeps = system.solve(directAtSites, reflects, counted, s.residual,
                                     counted ? s.bounces : kMostRaySweeps, afterSweep);
        bool done = counted ? report.sweeps == s.bounces : report.residual <= s.residual;
        if (report.complete && !done && task.stopped()) {
            report.complete = false;
            keep();
        }
        if (!counted && !done && !task.stopped())
            report.notes.emplace_back(
                "the light does not converge: surfaces with a Kd of 1 reflect all of it");
    }

    void finalGather() {
        task.show(SolveStep::kFinalRays, 0);
        // Gather in parts, to report progress and to stop between them
        constexpr int kParts = 64;
        auto sites = (int64_t)grid.sites.size();
        for (int k = 0; k < kParts && !task.stopped(); ++k) {
            system.finalGather((int)(sites * k / kParts), (int)(sites * (k + 1) / kParts), s.finalRays,
                               task.solution);
            task.show(SolveStep::kFinalRays, (float)(k + 1) / kParts);
        }
        if (task.stopped()) { // keep the light of the sweeps
            report.complete = false;
            keep();
            return;
        }
        task.solution.light = lightOfTexels(kFinalShared);
    }

    // Direct and reflected light of all texels. Hidden ones are filled from their neighbours.
    std::vector<Rgb> lightOfTexels(float share) {
        std::vector<Rgb> light = system.atTexels(share);
        for (size_t t = 0; t < light.size(); ++t) light[t] += direct[t];
        grid.fill(light);
        return light;
    }
};

} // namespace

void solveByRays(SolveTask &task) {
    task.show(SolveStep::kDividing, 0);
    size_t bytes = memoryFor(task);
    if (bytes > task.settings.memory)
        refuseMemory(bytes, task.settings.memory, "larger elements or fewer rays need less");
    if (task.settings.needs) task.settings.needs(bytes);
    RaySolver(task).run();
}

} // namespace odraz::radiosity
