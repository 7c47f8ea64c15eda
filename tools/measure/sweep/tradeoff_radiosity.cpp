#include "tools/engine/machine.h"
#include "tools/measure/oracle/measured.h"
#include "tools/measure/oracle/reference_hall.h"
#include "tools/measure/sweep/tradeoff.h"
#include "tools/radiosity/reference/mesh_reference.h"

#include <algorithm>

using namespace odraz;
using namespace odraz::radiosity;

namespace {

using SolveSetting = Setting<SolveSettings>;
using HallSetting = Setting<RadiositySettings>;

// Varies one knob after the other, from the defaults of `radiosity solve`. With `patches` also those of
// solving between patches, for models of few polygons.
std::vector<SolveSetting> settings(bool quick, double area, bool patches) {
    std::vector<SolveSetting> all;
    SolveSettings plain;
    auto with = [&](const std::string &name, auto &&change) {
        SolveSetting s = {name, plain};
        change(s.value);
        all.push_back(s);
    };
    auto count = [](const char *what, int n) { return std::string(what) + " " + std::to_string(n); };
    all.push_back({"default", plain, true});
    // The quick round is for a test: it keeps models that take long small
    std::vector<int> rays = {16, 64, 256}, samples = {1, 64};
    if (quick) rays = {16}, samples.clear();
    if (quick && patches) rays = {16, 128}, samples = {4};
    for (int n : rays) with(count("rays", n), [&](SolveSettings &b) { b.rays = n; });
    for (int n : quick ? std::vector<int>{7500} : std::vector<int>{7500, 120000})
        with(count("elements", n), [&](SolveSettings &b) { b.element = area / n; });
    for (int n : quick ? std::vector<int>{} : std::vector<int>{256})
        with(count("final", n), [&](SolveSettings &b) { b.finalRays = n; });
    for (int n : samples) with(count("lamp samples", n), [&](SolveSettings &b) { b.lampSamples = n; });
    if (!patches) return all;
    plain.way = Way::kPatches;
    with("patches", [](SolveSettings &) {});
    std::vector<int> pixels = {32, 64, 100};
    if (quick) pixels = {8, 32, 64};
    for (int px : pixels) with(count("hemicube", px), [&](SolveSettings &b) { b.hemicube = px; });
    for (int n : quick ? std::vector<int>{1500} : std::vector<int>{375, 1500})
        with(count("patches", n), [&](SolveSettings &b) { b.patch = area / n; });
    for (int n : quick ? std::vector<int>{120000} : std::vector<int>{30000, 480000})
        with(count("adaptive", n), [&](SolveSettings &b) { b.element = area / n, b.adaptive = true; });
    for (unsigned n : quick ? std::vector<unsigned>{1} : std::vector<unsigned>{1, 2})
        with(count("rotation", (int)n), [&](SolveSettings &b) { b.turn = n * 100003; });
    // Anti-aliasing or more pixels? The same number of pixels for a patch, in one hemicube or in four
    pixels = {16, 32, 64};
    if (quick) pixels = {32, 64};
    for (int px : pixels) {
        with(count("by hemicube", px), [&](SolveSettings &b) { b.analytic = false, b.hemicube = px; });
        with(count("by 4 hemicubes", px / 2),
             [&](SolveSettings &b) { b.analytic = false, b.hemicube = px / 2, b.turns = 4; });
    }
    return all;
}

std::vector<HallSetting> hallKnobs(bool quick) {
    std::vector<HallSetting> all = {{"shipped", kHallSettings, true}};
    auto with = [&](const std::string &name, auto &&change) {
        HallSetting s = {name, kHallSettings};
        s.value.links = (size_t)24 << 20;
        change(s.value);
        all.push_back(s);
    };
    for (int px : quick ? std::vector<int>{32} : std::vector<int>{8, 32, 64})
        with("hemicube " + std::to_string(px), [&](RadiositySettings &s) { s.px = px; });
    for (int block : quick ? std::vector<int>{4} : std::vector<int>{3, 4})
        with("patches of " + std::to_string(block * block), [&](RadiositySettings &s) { s.block = block; });
    with("divided where light changes", [&](RadiositySettings &s) { s.levels = 1; });
    for (float residual : quick ? std::vector<float>{} : std::vector<float>{1e-3f, 1e-4f})
        with(residual < 1e-3f ? "residual 1e-4" : "residual 1e-3",
             [&](RadiositySettings &s) { s.residual = residual; });
    return all;
}

} // namespace

void odraz::tradeoffRadiosity(const Sweep &sweep) {
    pictures::Plot plot = {
        "radiosity: a room, a hall of columns, a corner, a vault, a terrain, and the film's hall",
        "processor time of a solution, s",
        "root mean square error, %",
        {"cube", "columns", "corner", "vault", "terrain", "hall"},
        {},
        true,
        true,
        true,
        true};
    plot.frontOfEach = true;
    Table table("scene,setting,shipped,cpu_s,rms_percent,median_percent", plot);
    auto put = [&](const char *scene, const std::string &name, bool shipped, double seconds, double rms,
                   double middle, int series) {
        table.row("%s,%s,%d,%.3f,%.3f,%.3f", scene, name.c_str(), shipped, seconds, rms, middle);
        if (name.starts_with("rotation")) return; // all would lie at one place
        // An error hidden by the paths' noise is 0, which a logarithmic scale cannot show
        table.plot.points.push_back({seconds, std::max(rms, 0.05), name, shipped, series});
    };
    Gl gl = openGl();
    Workers workers = allProcessors();
    int series = 0;
    for (const char *kind : {"cube", "columns", "corner", "vault", "terrain"}) {
        Mesh mesh = generatedMesh(kind, 0);
        std::vector<MeshProbe> probes;
        for (const SolveSetting &s : settings(sweep.quick, areaOf(mesh), series < 3)) {
            Solved solved = solveModel(mesh, s.value, gl, workers, &kNever, {});
            if (probes.empty()) { // the first is the default, whose light chooses the places
                // In a room, few places at the edges of shadows make most of the rms; but a median includes
                // the noise of the paths
                bool room = series < 3;
                probes = placeMeshProbes(solved.solution, (room ? 1000 : 300) * (sweep.quick ? 1 : 2));
                tracePaths(mesh, solved.surroundings, probes, (room ? 36 : 68) * (sweep.quick ? 1 : 2),
                           workers);
            }
            solvedAt(solved.solution, probes);
            MeshErrors e = errorsOf(probes);
            put(kind, s.name, s.shipped, solved.report.allSeconds, e.rms, e.median, series);
        }
        ++series;
    }
    RadiositySettings fine = {.px = 64, .block = 2, .levels = 1, .contrast = 0.05f};
    fine.links = (size_t)48 << 20;
    if (sweep.quick) fine.px = 32;
    SolvedHall best(fine, gl, workers, (size_t)1200 << 20);
    auto probes = gatherHall(best, sweep.quick ? 300 : 1000, sweep.quick ? 32 : 96, workers);
    for (const HallSetting &s : hallKnobs(sweep.quick)) {
        SolvedHall solved(s.value, gl, workers, (size_t)600 << 20);
        put("hall", s.name, s.shipped, solved.seconds, rmsPercent(solved, probes), 0, series);
    }
    table.save(sweep);
}
