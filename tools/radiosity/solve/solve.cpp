#include "tools/radiosity/solve/solve.h"

#include "tools/radiosity/rays/solve_by_rays.h"

#include <stdexcept>

namespace odraz::radiosity {

Vec3d offsetOf(const Mesh &mesh) {
    Vec3d middle = mesh.middle();
    return length(middle) < 4 * mesh.size() ? Vec3d{} : middle;
}

Mesh moved(const Mesh &mesh, const Vec3d &from) {
    Mesh near = mesh;
    for (Vec3d &p : near.points) p = p - from;
    return near;
}

namespace {

// Adds an even sky to a model in which nothing emits.
bool addEvenSky(SolveTask &task) {
    if (!task.settings.evenSky || emitsLight(task.mesh) || task.settings.surroundings.any()) return false;
    task.settings.surroundings.sky = evenSky({1, 1, 1});
    task.report.notes.emplace_back(
        "nothing in the model emits light: an even sky is added (--sky, --sun and --lamp add other light)");
    return true;
}

Solved run(SolveTask &task, const Gl &gl, const Vec3d &away, bool evenSky) {
    Solved solved;
    if (task.settings.way == Way::kRays)
        solveByRays(task);
    else
        solved.patches = solveByPatches(task, gl);
    for (Chart &chart : task.solution.charts) chart.corner += toFloat(away);
    solved.solution = std::move(task.solution);
    solved.report = std::move(task.report);
    solved.surroundings = std::move(task.settings.surroundings);
    solved.away = away;
    solved.evenSky = evenSky;
    return solved;
}

} // namespace

Solved solveModel(const Mesh &given, const SolveSettings &settings, const Gl &gl, Workers &workers,
                  const int *stop, const SolveProgress &progress) {
    Vec3d away = offsetOf(given);
    bool far = length(away) > 0;
    Mesh near;
    if (far) near = moved(given, away);
    SolveTask task(far ? near : given, settings, workers, stop, progress);
    for (BallLamp &lamp : task.settings.surroundings.lamps) lamp.centre = lamp.centre - toFloat(away);
    if (given.size() < length(away) * 1e-5)
        task.report.notes.emplace(
            task.report.notes.begin(),
            "the model lies too far from the origin for precise coordinates: move it closer");
    bool evenSky = addEvenSky(task);
    return run(task, gl, away, evenSky);
}

void refuseDark() {
    throw std::runtime_error(
        "nothing in the model emits light now, and its rows have no sky: solve it again");
}

Solved relightModel(const Mesh &materials, PreparedSolve prepared, bool evenSky, const Vec3d &away,
                    const SolveSettings &settings, Workers &workers, const int *stop,
                    const SolveProgress &progress) {
    SolveTask task(materials, prepared, settings, workers, stop, progress);
    bool dark = task.emitters().empty() && !settings.surroundings.any();
    if (dark && settings.evenSky && !evenSky) refuseDark();
    if (dark && settings.evenSky)
        task.settings.surroundings.sky = radiosity::evenSky({1, 1, 1});
    else if (evenSky)
        prepared.direct.outside.clear();
    return run(task, {}, away, evenSky);
}

} // namespace odraz::radiosity
