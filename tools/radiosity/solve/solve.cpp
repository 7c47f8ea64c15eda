#include "tools/radiosity/solve/solve.h"

#include "tools/radiosity/rays/solve_by_rays.h"

#include <stdexcept>

namespace odraz::radiosity {

namespace {

// Adds an even sky to a model in which nothing emits.
bool addEvenSky(SolveTask &task) {
    if (!task.settings.evenSky || emitsLight(task.mesh) || task.settings.surroundings.any()) return false;
    task.settings.surroundings.sky = evenSky({1, 1, 1});
    task.report.notes.emplace_back(
        "nothing in the model emits light: an even sky is added (--sky, --sun and --lamp add other light)");
    return true;
}

Solved run(SolveTask &task, const Gl &gl, bool evenSky) {
    Solved solved;
    if (task.settings.way == Way::kRays)
        solveByRays(task);
    else
        solved.patches = solveByPatches(task, gl);
    solved.solution = std::move(task.solution);
    solved.report = std::move(task.report);
    solved.surroundings = std::move(task.settings.surroundings);
    solved.evenSky = evenSky;
    return solved;
}

} // namespace

Solved solveModel(const Mesh &mesh, const SolveSettings &settings, const Gl &gl, Workers &workers,
                  const int *stop, const SolveProgress &progress) {
    SolveTask task(mesh, settings, workers, stop, progress);
    bool evenSky = addEvenSky(task);
    return run(task, gl, evenSky);
}

void refuseDark() {
    throw std::runtime_error(
        "nothing in the model emits light now, and its rows have no sky: solve it again");
}

Solved relightModel(const Mesh &materials, PreparedSolve prepared, bool evenSky,
                    const SolveSettings &settings, Workers &workers, const int *stop,
                    const SolveProgress &progress) {
    SolveTask task(materials, prepared, settings, workers, stop, progress);
    bool dark = task.emitters().empty() && !settings.surroundings.any() &&
                (evenSky || prepared.direct.outside.empty());
    if (dark && settings.evenSky && !evenSky) refuseDark();
    if (dark && settings.evenSky)
        task.settings.surroundings.sky = radiosity::evenSky({1, 1, 1});
    else if (evenSky)
        prepared.direct.outside.clear();
    return run(task, {}, evenSky);
}

} // namespace odraz::radiosity
