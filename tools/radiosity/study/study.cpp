#include "tools/radiosity/study/study.h"

#include "tools/common/clock.h"
#include "tools/radiosity/patches/odd_hemicube.h"
#include "tools/radiosity/patches/shooting.h"

#include <algorithm>
#include <cmath>

namespace odraz {

Stopwatch::Stopwatch() : startProcessor(processorSeconds()), startWall(wallSeconds()) {}
double Stopwatch::processor() const { return processorSeconds() - startProcessor; }
double Stopwatch::wall() const { return wallSeconds() - startWall; }

Study::Study(const StudySettings &settings, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop,
             Page &page, ProgressBar &progressBar)
    : settings(settings), mesh(mesh), gl(gl), workers(workers), stop(stop), page(page), area(areaOf(mesh)),
      bar(progressBar), began(wallSeconds()) {
    chapter("reference", 0.1);
    SolveSettings s = settings.solve;
    s.finalRays = settings.minutes >= 2 ? 256 : 64;
    reference = solve(s).solution;
    facets = (int)reference.facets.size();
    places.emplace(reference, 2000);
    afterReference = wallSeconds();
}

void Study::chapter(const char *named, double share) {
    name = named;
    double from = afterReference > 0 ? afterReference : began, end = began + settings.minutes * 60;
    until = from + share * std::max(end - from, 0.);
    tick();
}

double Study::left() const { return until - wallSeconds(); }

void Study::check() const {
    if (__atomic_load_n(stop, __ATOMIC_RELAXED)) throw Interrupted();
}

void Study::tick() {
    check();
    double done = (wallSeconds() - began) / (settings.minutes * 60);
    bar.show(name, (float)std::min(done, 0.99), -1);
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
    Solved solved = solveModel(mesh, s, gl, workers, stop, [this](const char *, float, float) { tick(); });
    check();
    for (const std::string &note : solved.report.notes)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    return solved;
}

Solved Study::measure(const std::string &what, const std::string &options, const SolveSettings &s) {
    Stopwatch watch;
    Solved solved = solve(s);
    measured.push_back({what, options, watch.processor(), watch.wall(), places->errorsOf(solved.solution)});
    return solved;
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

double Study::hemicubeSeconds(const Model &m, int px) {
    Stopwatch watch;
    std::vector<Rgb> light((size_t)m.patchCount, Rgb{1, 1, 1}), none((size_t)m.patchCount);
    Shooting shooting(m, patchesAlone(m), light, none);
    HemicubeShooter shooter(gl, m, px, 1);
    double best = INFINITY;
    // The first picture also compiles the shaders
    for (int i = 0; i < 3; ++i) {
        Stopwatch one;
        int shots = shooter.shoot(shooting, shooter.batch(), workers);
        if (shots > 0) best = std::min(best, one.wall() / shots);
        tick();
        if (watch.wall() > 5) break;
    }
    return std::isfinite(best) ? best : 0;
}

} // namespace odraz
