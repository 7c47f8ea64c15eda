#include "tools/radiosity/study/study.h"

#include "tools/common/text.h"
#include "tools/radiosity/divide/regions.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

Study::Study(const StudySettings &settings, const Mesh &mesh, Page &page, bool progress)
    : settings(settings), mesh(mesh), page(page), bar(progress), tasks(settings.tasks + 3) {
    Regions regions = joinRegions(mesh, std::sqrt(area / 30000));
    if (size_t most = std::max(regions.charts.size(), regions.facets.size()); most > (size_t)kMaxFacets)
        throw ModelError(
            settings.model + ": " + std::to_string(most) +
            " polygons are left after joining those in one plane; a study needs hemicubes, which take "
            "at most " +
            std::to_string(kMaxFacets) + ": give it a part of the model");
    // Also compare the solution with default settings
    Stopwatch watch;
    Solved solved = solve(settings.solve);
    Solution plain = std::move(solved.solution);
    double seconds = watch.processor(), wall = watch.wall();
    SolveSettings s = settings.solve;
    s.finalRays = settings.finalRays();
    if (settings.quick) s.element = area / 30000; // a fourth of the elements of a final gather
    reference = solve(s).solution;
    places = placeMeshProbes(reference, 2000);
    solvedAt(reference, places);
    for (MeshProbe &p : places) p.traced = p.solved;
    measured.push_back({common::counted(plain.elements(), "element") + ", by rays", command(""), seconds,
                        wall, errorsOf(plain)});
    comparePaths(plain, solved.surroundings);
}

void Study::comparePaths(const Solution &byRays, const Surroundings &surroundings) {
    const int side = settings.quick ? 16 : 48;
    std::vector<MeshProbe> probes = placeMeshProbes(reference, 300);
    tracePaths(mesh, surroundings, probes, side, workers, stop);
    taskDone();
    referenceText =
        "The error of the reference itself is not known: no light reaches the places that were tried.";
    if (probes.empty()) return;
    const MeshErrors errors = radiosity::errorsOf(probes);
    if (!std::isfinite(errors.noise)) return;
    solvedAt(byRays, probes);
    // An error below the paths' noise cannot be distinguished from it
    auto shownErrors = [](const MeshErrors &m) {
        return "by " + (m.rms < m.noise / 2 ? "less than " + shown(m.noise, 2) : shown(m.rms, 2)) +
               " % (rms; median " + shown(m.median, 2) + " %)";
    };
    referenceText =
        "The reference itself differs from path tracing, which uses neither its rays nor its "
        "elements, " +
        shownErrors(errors) + ": at " + std::to_string(probes.size()) + " places with " +
        std::to_string(2 * side * side) + " paths from each, whose own noise of " + shown(errors.noise, 2) +
        " % is subtracted from the rms. Smaller errors in the tables mean little. The solution by "
        "rays, which radiosity solve finds without options, has rays and elements like the "
        "reference's, so its error against it is underestimated; it differs from the paths " +
        shownErrors(radiosity::errorsOf(probes)) + ".";
}

void Study::check() const {
    if (__atomic_load_n(stop, __ATOMIC_RELAXED)) throw Interrupted();
}

void Study::taskDone() {
    check();
    ++done;
    show(0);
}

void Study::show(float part) { bar.show(name, std::min(((float)done + part) / (float)tasks, 0.99f), -1); }

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
    s.method = SolveMethod::kPatches;
    s.analytic = false;
    s.patch = s.element = area / patches;
    s.hemicube = px;
    return s;
}

Solved Study::solve(const SolveSettings &s) {
    // Count each step the same. Do not throw here, where threads may be running: solveModel() itself watches
    // `stop`
    constexpr int kSteps = (int)std::size(kStepNames);
    auto progress = [&](const char *step, float part, float) {
        auto at = std::find(std::begin(kStepNames), std::end(kStepNames), step) - std::begin(kStepNames);
        show(std::min((float)at + part, (float)kSteps) / kSteps);
    };
    Solved solved =
        solveNamed(settings.model, [&] { return solveModel(mesh, s, gl, workers, stop, progress); });
    taskDone();
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

Solved Study::measure(int patches, int px, int shots) {
    SolveSettings s = thesis(patches, px);
    std::string name = std::to_string(px) + " px",
                options = "--direct hemicube --hemicube " + std::to_string(px) + " --patch " +
                          shown(s.patch, 6) + " --element " + shown(s.element, 6);
    if (shots > 0) {
        s.shots = shots, s.residual = 0.005f;
        options += " --shots " + std::to_string(shots) + " --residual 0.005";
    }
    Stopwatch watch;
    Solved solved = solve(s);
    measured.push_back({common::counted((size_t)solved.report.patches, "patch") +
                            (shots > 0 ? ", shot by " : ", by ") + name,
                        command(options), watch.processor(), watch.wall(), errorsOf(solved.solution)});
    return solved;
}

Eye cornerEye(const Model &m, int patch, int k) {
    const Patch &p = m.patches[patch];
    const Chart &c = m.charts[p.chart];
    Vec3 at = p.p;
    if (p.share == 1) {
        int x = (patch - c.firstPatch) % c.patchesAcross, y = (patch - c.firstPatch) / c.patchesAcross;
        float inside[2] = {0.1f, 0.9f};
        at = c.at(((float)x + inside[k & 1]) * c.width / (float)c.patchesAcross,
                  ((float)y + inside[k >> 1]) * c.height / (float)c.patchesDown);
    }
    return hemicubeEye(at, p.n, (uint32_t)patch * 4 + (uint32_t)k);
}

} // namespace odraz::radiosity
