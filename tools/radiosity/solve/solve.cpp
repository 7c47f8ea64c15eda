#include "tools/radiosity/solve/solve.h"

#include "tools/radiosity/rays/ray_system.h"

namespace odraz::radiosity {

// Adds an even sky if nothing emits light.
static void addEvenSky(SolveTask &task) {
    if (!task.settings.evenSky || emitsLight(task.mesh) || task.settings.surroundings.any()) return;
    task.settings.surroundings.sky = evenSky({1, 1, 1});
    task.report.notes.emplace_back(
        "nothing in the model emits light: an even sky is added (--sky, --sun and --lamp add other light)");
}

// Whether no light arrives at any polygon that is not a lamp, though there are such polygons.
static bool isDark(const Solution &b) {
    bool reflectors = false;
    for (size_t i = 0; i < b.texels.size(); ++i) {
        if (maxComponent(b.emits[(size_t)b.texels[i].chart]) > 0) continue;
        if (maxComponent(b.light[i]) > 0) return false;
        reflectors = true;
    }
    return reflectors;
}

Solved solveModel(const Mesh &mesh, const SolveSettings &settings, const Gl &gl, Workers &workers,
                  const int *stop, const SolveProgress &progress) {
    SolveTask task(mesh, settings, workers, stop, progress);
    addEvenSky(task);
    Solved solved;
    if (settings.method == SolveMethod::kRays)
        solveByRays(task);
    else
        solved.patches = solveByPatches(task, gl);
    if (task.report.complete && isDark(task.solution)) task.report.notes.emplace_back(kDarkNote);
    solved.solution = std::move(task.solution);
    solved.report = std::move(task.report);
    solved.surroundings = std::move(task.settings.surroundings);
    return solved;
}

} // namespace odraz::radiosity
