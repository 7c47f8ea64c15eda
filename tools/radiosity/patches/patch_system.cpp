#include "tools/radiosity/patches/patch_system.h"

#include "base/random.h"
#include "tools/radiosity/patches/shooting.h"
#include "tools/radiosity/rays/lamp_rays.h"

#include "radiosity/solve.h"
#include "radiosity/spread.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace odraz::radiosity {

namespace {

constexpr int kMostSweeps = 10000;

// Whether one of about 500 patches sees the back of a surface. If none does, hemicubes draw no backs.
bool seesBacks(const Model &m, const RayTree &tree) {
    static constexpr int kPatches = 500, kDirections = 96;
    for (int i = 0, every = std::max(1, m.patchCount / kPatches); i < m.patchCount; i += every) {
        const Patch &p = m.patches[i];
        const Chart &c = m.charts[p.chart];
        for (int k = 0; p.share > 0 && k < kDirections; ++k) {
            float up = 1 - ((float)k + 0.5f) / kDirections, out = std::sqrt(1 - up * up),
                  turn = 2.3999632f * (float)k;
            Vec3 d = c.u * (out * std::cos(turn)) + c.v * (out * std::sin(turn)) + c.n * up;
            if (tree.nearest(p.p + c.n * c.off(), d).back) return true;
        }
    }
    return false;
}

// The sky's light at all texels, by rays. They follow the cosine law, in a spiral (Vogel, 1979: the golden
// angle on a disc) with a different rotation at every texel. They start from the texel's sample points in
// turn.
std::vector<Rgb> skyLight(const SkyPicture &sky, const LightGrid &grid, Workers &workers) {
    constexpr int kRays = 256;
    std::vector<std::vector<Vec3>> pointsOf(grid.texels.size());
    for (const LightGrid::SamplePoint &point : grid.points) pointsOf[(size_t)point.texel].push_back(point.p);
    std::vector<Rgb> light(grid.texels.size());
    parallelRanges(workers, (int)light.size(), 64, [&](int first, int end, int) {
        for (auto t = (size_t)first; t < (size_t)end; ++t) {
            const Chart &c = grid.charts[(size_t)grid.texels[t].chart];
            const std::vector<Vec3> &points = pointsOf[t];
            float begin = unitFloat(pcg((uint32_t)t)) * 6.2831853f;
            for (int k = 0; k < kRays && !points.empty(); ++k) {
                float square = ((float)k + 0.5f) / kRays, out = std::sqrt(square),
                      turn = begin + 2.3999632f * (float)k;
                Vec3 d =
                    c.u * (out * std::cos(turn)) + c.v * (out * std::sin(turn)) + c.n * std::sqrt(1 - square);
                if (!grid.tree.blocked(points[(size_t)k % points.size()], d, kInfinity))
                    light[t] += sky.radiance(d) * (1.f / kRays);
            }
        }
    });
    return light;
}

// The number of cells along a side of a patch.
int cellsOfPatch(const SolveTask &task) {
    const SolveSettings &s = task.settings;
    // Hemicubes take longer in models of many polygons, so use fewer
    auto polygons = (double)task.regions.facets.size();
    double patch =
        s.patch > 0 ? s.patch : areaOf(task.mesh) / std::clamp(6000. * 2000 / polygons, 400., 6000.);
    return (int)std::clamp(std::sqrt(patch) / cellSide(task.mesh, s) + 0.5, 1., (double)kMaxAcross);
}

class PatchSolver {
public:
    PatchSolver(SolveTask &task, PatchSystem &p, const Gl &gl) : task(task), p(p), gl(gl) {}

    void run() {
        divide();
        task.lap(SolveStep::kDividing);
        findDirectLight();
        task.lap(SolveStep::kDirectLight);
        if (s.shots > 0) {
            shootLight();
        } else {
            findRows();
            task.lap(SolveStep::kFormFactors);
            solve();
        }
        spread();
        task.lap(SolveStep::kSolving);
        p.cells = std::move(grid.cells), p.texels = std::move(grid.texels);
    }

private:
    SolveTask &task;
    SolveSettings &s = task.settings;
    SolveReport &report = task.report;
    PatchSystem &p;
    Model &m = *p.model;
    const Gl &gl;
    LightGrid grid{task.mesh, task.regions, task.workers, cellsOfPatch(task)};
    std::vector<Rgb> direct;  // light of texels
    std::vector<Rgb> arrives; // light at patches, without direct light

    void divide() {
        fillModel(m, task.regions);
        m.cells = grid.cells.data(), m.cellCount = (int)grid.cells.size();
        m.texels = grid.texels.data(), m.texelCount = (int)grid.texels.size();
        const Chart &last = m.charts[m.chartCount - 1];
        p.patches.resize((size_t)(last.firstPatch + last.patchesAcross * last.patchesDown));
        m.patches = p.patches.data(), m.patchCount = report.patches = (int)p.patches.size();
        m.placePatches();
        m.open = seesBacks(m, grid.tree);
        task.setGeometry(grid.cells, grid.texels);
        for (Patch &patch : p.patches) {
            patch.reflects = task.solution.reflects[(size_t)patch.chart];
            p.emits.push_back(s.analytic ? Rgb{} : task.solution.emits[(size_t)patch.chart]);
        }
        task.pictured.toPatches(m);
        task.show(SolveStep::kDividing, 1);
    }

    void findDirectLight() {
        task.show(SolveStep::kDirectLight, 0);
        LampRays lamps(task.mesh, task.regions, s.lampSamples);
        if (!s.analytic) lamps.clear();
        const std::vector<uint16_t> none(grid.sites.size());
        direct = directLight(lamps, s.surroundings, grid, none, task.workers);
        if (s.surroundings.sky.width) {
            std::vector<Rgb> sky = skyLight(s.surroundings.sky, grid, task.workers);
            for (size_t t = 0; t < sky.size(); ++t) direct[t] += sky[t];
        }
        p.direct.resize(p.patches.size());
        for (const Cell &cell : grid.cells)
            for (int k = 0; k < 4; ++k)
                if (m.quarterVisible(cell, k))
                    p.direct[(size_t)cell.patch] += direct[(size_t)cell.corner[k]] * (cell.area / 4);
        for (size_t i = 0; i < p.patches.size(); ++i)
            if (p.patches[i].area > 0) p.direct[i] = p.direct[i] * (1 / p.patches[i].area);
        task.show(SolveStep::kDirectLight, 1);
    }

    // Finds the rows of visible patches that reflect or emit, in an order that spreads the first ones over
    // the model. A row is the mean of `each` hemicubes. Without `eyeOf` all are in the patch's middle,
    // rotated differently.
    void findRows() {
        p.rows = FormFactorRows(p.patches.size());
        if (s.each == 0) return;
        AnyHemicubes hemicubes(gl, s.hemicube);
        std::vector<uint8_t> lit;
        for (size_t i = 0; i < p.patches.size(); ++i)
            lit.push_back(maxComponent(p.patches[i].reflects) > 0 || maxComponent(p.emits[i]) > 0);
        auto each = (size_t)s.each, count = lit.size(), batch = (size_t)hemicubes.h.batch / each,
             links = (size_t)0, step = (size_t)((double)count * 0.6180339) | 1;
        while (std::gcd(step, count) != 1) step += 2;
        for (size_t i = 0, next = 0; i < count && report.complete;) {
            std::vector<Eye> eyes;
            std::vector<size_t> patches;
            for (; i < count && patches.size() < batch; ++i, next = (next + step) % count) {
                const Patch &patch = p.patches[next];
                if (patch.share == 0 || !lit[next]) continue;
                for (uint32_t k = 0; k < each; ++k)
                    eyes.push_back(s.eyeOf ? s.eyeOf(m, (int)next, (int)k)
                                           : hemicubeEye(patch.p, patch.n, (uint32_t)next + k * 0x9e3779b9u));
                patches.push_back(next);
            }
            const auto &found = hemicubes.rows(m, eyes, task.workers);
            for (size_t k = 0; k < patches.size(); ++k) {
                std::vector<Link> &row = p.rows.of[patches[k]];
                for (size_t j = 0; j < count; ++j) {
                    float sum = 0;
                    for (size_t e = 0; e < each; ++e) sum += found[k * each + e][j];
                    if (sum > 0 && lit[j]) row.push_back({(uint32_t)j, sum / (float)each});
                }
                row.shrink_to_fit();
                p.rows.known[patches[k]] = true;
                links += row.size();
            }
            report.rows += (int)patches.size();
            if (size_t bytes = links * sizeof(Link) / i * count; bytes > s.memory)
                refuseMemory(bytes, s.memory, "larger patches or elements need less");
            task.show(SolveStep::kFormFactors, (float)i / (float)count);
            report.complete = !task.stopped();
        }
    }

    void solve() {
        std::vector<Rgb> lampLight; // found by hemicubes
        for (size_t i = 0; i < p.patches.size(); ++i) lampLight.push_back(p.rows.gather((int)i, p.emits));
        for (size_t i = 0; i < lampLight.size(); ++i) p.direct[i] += lampLight[i];
        const bool counted = s.bounces >= 0;
        std::vector<Rgb> radiosity = counted ? std::vector<Rgb>(lampLight.size()) : p.reflectDirect();
        if (!counted) report.residual = kInfinity;
        while (report.complete && report.sweeps < (counted ? s.bounces : kMostSweeps) &&
               (counted || report.residual > s.residual)) {
            report.residual = p.sweep(radiosity, !counted);
            ++report.sweeps;
            float share =
                counted ? (float)report.sweeps / (float)s.bounces : task.solvedShare(report.residual);
            task.show(SolveStep::kSolving, share, counted ? -1 : report.residual);
            report.complete = !task.stopped();
        }
        for (size_t i = 0; i < p.patches.size(); ++i)
            arrives.push_back(p.rows.gather((int)i, radiosity) + lampLight[i]);
    }

    // Shoots light instead of solving with rows.
    void shootLight() {
        // A quarter of the shots is for lamps. With the rest each block shoots about three times
        Shooting shooting(m, blocksOfPatches(m, p.emits, std::max(s.shots / 4, 1)), p.emits, p.direct);
        AnyHemicubes hemicubes(gl, s.hemicube);
        for (int most; (most = s.shots - report.shots) > 0 && shooting.left() > (double)s.residual;) {
            if (task.stopped()) report.complete = false;
            int shot = report.complete ? shooting.shoot(hemicubes, most, task.workers) : 0;
            if (shot == 0) break;
            report.shots += shot;
            task.show(SolveStep::kSolving, (float)report.shots / (float)s.shots, (float)shooting.left());
        }
        report.residual = (float)shooting.left();
        Rgb ambient = shooting.ambient();
        for (const Rgb &light : shooting.arrives()) arrives.push_back(light + ambient);
        p.rows = FormFactorRows(p.patches.size());
        for (size_t i = 0; i < p.patches.size(); ++i) p.rows.known[i] = p.patches[i].share > 0;
    }

    // Spreads light from the patches to the texels. Hidden patches and texels get their neighbours' light.
    void spread() {
        constexpr size_t kColumns = 8;
        std::vector<FormFactorRow> known;
        std::vector<float> values;
        for (size_t i = 0; i < arrives.size(); ++i) {
            known.push_back({nullptr, 0, p.rows.known[i] != 0});
            values.insert(values.end(), {arrives[i].x, arrives[i].y, arrives[i].z, 0, 0, 0, 0, 0});
        }
        fillPatches(m, {nullptr, known.data(), 0, 0}, kColumns, values.data(), 0, m.patchCount);
        std::vector<float> planes[3];
        float *to[3];
        for (size_t k = 0; k < 3; ++k) planes[k].resize(direct.size() + 8), to[k] = planes[k].data();
        addToTexels(m, values.data(), kColumns, to, 3, task.workers);
        std::vector<Rgb> &light = task.solution.light = direct;
        for (size_t t = 0; t < light.size(); ++t) light[t] += {to[0][t], to[1][t], to[2][t]};
        grid.fill(light);
    }
};

} // namespace

std::vector<Rgb> PatchSystem::reflectDirect() const {
    std::vector<Rgb> all;
    for (size_t i = 0; i < patches.size(); ++i) all.push_back(patches[i].reflects * direct[i]);
    return all;
}

float PatchSystem::sweep(std::vector<Rgb> &b, bool atOnce) const {
    Rgb initial = {}, change = {};
    std::vector<Rgb> before;
    if (!atOnce) before = b;
    for (size_t i = 0; i < patches.size(); ++i) {
        const Rgb &reflects = patches[i].reflects;
        Rgb now = reflects * (direct[i] + rows.gather((int)i, atOnce ? b : before));
        initial += reflects * direct[i];
        change += {std::fabs(now.x - b[i].x), std::fabs(now.y - b[i].y), std::fabs(now.z - b[i].z)};
        b[i] = now;
    }
    auto share = [](float part, float all) { return all > 0 ? part / all : 0; };
    return std::max({share(change.x, initial.x), share(change.y, initial.y), share(change.z, initial.z)});
}

std::unique_ptr<PatchSystem> solveByPatches(SolveTask &task, const Gl &gl) {
    size_t texels = 0;
    for (const Chart &c : task.regions.charts) texels += (size_t)c.texels();
    if (size_t bytes = texels * 250; bytes > task.settings.memory)
        refuseMemory(bytes, task.settings.memory, "larger elements need less");
    task.show(SolveStep::kDividing, 0);
    auto p = std::make_unique<PatchSystem>();
    PatchSolver(task, *p, gl).run();
    return p;
}

} // namespace odraz::radiosity
