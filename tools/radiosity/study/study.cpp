#include "tools/radiosity/study/study.h"

#include "tools/common/clock.h"
#include "tools/common/text.h"
#include "tools/radiosity/divide/regions.h"
#include "tools/radiosity/patches/shooting.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace odraz::radiosity {

static constexpr int kCoarse = 1500;
static constexpr double kReferenceShare = 0.1; // of the time

Stopwatch::Stopwatch() : startProcessor(common::processorSeconds()), startWall(common::wallSeconds()) {}
double Stopwatch::processor() const { return common::processorSeconds() - startProcessor; }
double Stopwatch::wall() const { return common::wallSeconds() - startWall; }

Study::Study(const StudySettings &settings, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop,
             Page &page, ProgressBar &progressBar)
    : settings(settings), mesh(mesh), gl(gl), workers(workers), stop(stop), page(page), area(areaOf(mesh)),
      bar(progressBar), began(common::wallSeconds()) {
    Regions regions = joinRegions(mesh, std::sqrt(area / 30000));
    if (size_t most = std::max(regions.charts.size(), regions.facets.size()); most > (size_t)kMaxFacets)
        throw ModelError(
            settings.model + ": " + std::to_string(most) +
            " polygons are left after joining those in one plane; a study needs hemicubes, which "
            "take " +
            std::to_string(kMaxFacets) + ": give it a part of the model");
    chapter("reference", kReferenceShare);
    // Solve with the tool's defaults first: this is compared too, and a final gather of 256 rays takes about
    // three times as long in a model of many polygons. With too few rays a gather is worse than none
    Stopwatch watch;
    Solved solved = solve(settings.solve);
    Solution plain = std::move(solved.solution);
    MeasuredSolution byRays = {std::to_string(plain.elements()) + " elements, by rays",
                               command(""),
                               watch.processor(),
                               watch.wall(),
                               {}};
    SolveSettings s = settings.solve;
    double share = byRays.wall / (settings.minutes * 60);
    s.finalRays = share < 0.01 ? 512 : share < 0.03 ? 256 : share < 0.06 ? 128 : 0;
    finalRays = s.finalRays;
    reference = s.finalRays ? solve(s).solution : plain;
    if (std::all_of(reference.light.begin(), reference.light.end(),
                    [](const Rgb &c) { return maxComponent(c) <= 0; }))
        notes.emplace_back("no light reaches the fronts of the polygons: try --two-sided, or another light");
    places = placeMeshProbes(reference, 2000);
    solvedAt(reference, places);
    for (MeshProbe &p : places) p.traced = p.solved;
    byRays.errors = errorsOf(plain);
    if (s.finalRays) measured.push_back(byRays);
    compare(plain, solved.surroundings);
    check();
    afterReference = common::wallSeconds();
}

void Study::compare(const Solution &byRays, const Surroundings &around) {
    ReferenceErrors &e = referenceErrors;
    // Estimate from the time of a few paths the number that can be traced
    constexpr int kPlaces = 300, kFewest = 8, kMost = 128;
    const double seconds = std::min(settings.minutes * 60 * 0.03, 30.);
    std::vector<MeshProbe> &probes = traced;
    probes = placeMeshProbes(reference, kPlaces);
    std::vector<MeshProbe> first = probes;
    Stopwatch watch;
    tracePaths(mesh, around, first, kFewest, workers, stop);
    double share = seconds / std::max(watch.wall(), 1e-6);
    int side = std::clamp((int)(kFewest * std::sqrt(share)), kFewest, kMost);
    tracePaths(mesh, around, probes, side, workers, stop);
    check();
    e.unknown = "no light reaches the places that were tried";
    if (probes.empty()) return;
    e.places = probes.size(), e.paths = 2 * side * side;
    e.reference = radiosity::errorsOf(probes);
    solvedAt(byRays, probes);
    e.byRays = radiosity::errorsOf(probes);
    if (std::isfinite(e.reference.noise)) e.unknown.clear();
}

void Study::chapter(const char *named, double end) {
    name = named;
    double from = afterReference > 0 ? afterReference : began, last = began + settings.minutes * 60;
    until = from + end * std::max(last - from, 0.);
    tick();
}

double Study::left() const { return until - common::wallSeconds(); }

void Study::check() const {
    if (__atomic_load_n(stop, __ATOMIC_RELAXED)) throw Interrupted();
}

void Study::tick() {
    check();
    show();
}

void Study::show() {
    double done = partTo > 0 ? partFrom + (partTo - partFrom) * partDone
                             : (common::wallSeconds() - began) / (settings.minutes * 60);
    bar.show(name, (float)std::min(done, 0.99), -1);
}

void Study::print(const std::string &line) {
    bar.clear();
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

RenderSettings Study::camera() const {
    RenderSettings camera;
    camera.width = 360, camera.height = 270;
    camera.upIsZ = settings.upIsZ;
    placeCamera(reference, camera);
    return camera;
}

SolveSettings Study::thesis(int patches, int px) const {
    SolveSettings s = settings.solve;
    s.way = Way::kPatches;
    s.analytic = false;
    s.patch = s.element = area / patches;
    s.hemicube = px;
    return s;
}

Solved Study::solve(const SolveSettings &s) {
    partDone = 0;
    auto progress = [&](const char *step, float done, float) {
        // With shots only solving takes time
        if (s.shots > 0 && step && step == std::string_view(kStepNames[(int)SolveStep::kSolving]))
            partDone = (double)done;
        show(); // do not throw here, where threads may be running: solveModel() itself watches `stop`
    };
    Solved solved =
        solveNamed(settings.model, [&] { return solveModel(mesh, s, gl, workers, stop, progress); });
    check();
    for (const std::string &note : solved.report.notes)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    return solved;
}

std::string Study::command(const std::string &options) const {
    return "radiosity solve " + common::shellWord(settings.model) + " -o OUT.rad" + settings.options +
           (options.empty() ? "" : " ") + options;
}

MeshErrors Study::errorsOf(const Solution &solution) const {
    std::vector<MeshProbe> probes = places;
    solvedAt(solution, probes);
    return radiosity::errorsOf(probes);
}

Solved Study::measure(const std::string &kind, const std::string &options, const SolveSettings &s) {
    Stopwatch watch;
    Solved solved = solve(s);
    std::string count = s.analytic ? std::to_string(solved.solution.elements()) + " elements"
                                   : std::to_string(solved.report.patches) + " patches";
    measured.push_back(
        {count + ", " + kind, command(options), watch.processor(), watch.wall(), errorsOf(solved.solution)});
    return solved;
}

Solved Study::gather(int patches, int px) {
    SolveSettings s = thesis(patches, px);
    std::string name = std::to_string(px);
    return measure("by " + name + " px",
                   "--direct hemicube --hemicube " + name + " --patch " + shown(s.patch, 6) + " --element " +
                       shown(s.element, 6),
                   s);
}

Solved Study::divide(int patches) {
    SolveSettings s = thesis(patches, 16);
    s.bounces = 0;
    s.findRows = [](const Model &m, const Scene &, const uint8_t *, Workers &, Arena &arena,
                    FormFactors &factors, const Progress &) {
        factors.rows = arena.take<Row>((size_t)m.patchCount);
        return true;
    };
    return solve(s);
}

int Study::patchesFor(int asked) const {
    double side = std::sqrt(area / asked), all = 0;
    for (const Chart &c : reference.charts)
        all += std::max(1., std::round((double)c.width / side)) *
               std::max(1., std::round((double)c.height / side));
    return (int)std::min(all, 1e9);
}

const Solved &Study::divided(int patches, Solved &own) {
    divideSeconds();
    if (patchesFor(patches) < 1.2 * patchesFor(kCoarse) && patches >= kCoarse) return coarse;
    own = divide(patches);
    return own;
}

double Study::divideSeconds() {
    if (coarse.patches) return coarseSeconds;
    Stopwatch watch;
    coarse = divide(kCoarse);
    return coarseSeconds = watch.wall();
}

double Study::hemicubeSeconds(int px) {
    divideSeconds();
    if (auto known = costs.find(px); known != costs.end()) return known->second;
    const Model &m = *coarse.patches->model;
    std::vector<Rgb> light((size_t)m.patchCount, Rgb{1, 1, 1}), none((size_t)m.patchCount);
    Shooting shooting(m, patchesAlone(m), light, none);
    HemicubeShooter shooter(gl, m, px);
    double best = INFINITY;
    // The first picture also compiles the shaders. If hemicubes are slow, a few are enough
    Stopwatch watch;
    for (int i = 0, count = 4; i < 3 && watch.wall() < 2; ++i) {
        Stopwatch one;
        int shots = shooter.shoot(shooting, count, workers);
        if (shots == 0) break;
        double each = one.wall() / shots;
        best = std::min(best, each);
        count = (int)std::clamp(0.5 / std::max(each, 1e-6), 4., 256.);
        tick();
    }
    return costs[px] = std::isfinite(best) ? best : 0;
}

} // namespace odraz::radiosity
