#include "tools/radiosity/solution/solve_task.h"

#include "tools/common/clock.h"
#include "tools/common/text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace odraz::radiosity {

double cellSide(const Mesh &mesh, const SolveSettings &s) {
    // Elements are smaller with final rays, which are for quality
    double element = s.element > 0 ? s.element : areaOf(mesh) / (s.finalRays > 0 ? 120000 : 30000);
    return std::sqrt(element);
}

void refuseMemory(size_t bytes, size_t most, const char *remedy) {
    throw std::runtime_error("needs about " + std::to_string(bytes >> 20) + " MB, more than the " +
                             std::to_string(most >> 20) + " of --memory: " + remedy);
}

SolveTask::SolveTask(const Mesh &mesh, const SolveSettings &settings, Workers &workers, const int *stop,
                     const SolveProgress &progress)
    : mesh(mesh), settings(settings), workers(workers), stop(stop), progress(progress) {
    double side = cellSide(mesh, settings);
    regions = joinRegions(mesh, side);
    int coarse = 0;
    for (Chart &c : regions.charts) {
        coarse += (double)std::max(c.width, c.height) > (kMaxAcross + 1) * side;
        // A chart about as large as an element becomes one element
        if ((double)(c.width * c.height) < 3 * side * side) c.across = c.down = 1;
    }
    if (coarse > 0)
        report.notes.push_back(common::counted((size_t)coarse, "polygon is", "polygons are") +
                               " longer than " + std::to_string(kMaxAcross) +
                               " elements: elements there are longer than --element asks");
    solution.origin = mesh.origin;
    this->settings.surroundings.moveTo(mesh.origin);
    std::map<std::string, int> offsets; // where each name begins
    auto offsetOf = [&](const std::string &name) {
        auto [entry, isNew] = offsets.try_emplace(name, (int)solution.names.size());
        if (isNew) solution.names.insert(solution.names.end(), name.c_str(), name.c_str() + name.size() + 1);
        return entry->second;
    };
    const MeshObject none;
    for (size_t i = 0; i < regions.charts.size(); ++i) {
        const MeshMaterial &m = mesh.materials[(size_t)regions.material[i]];
        const MeshObject &o = regions.object[i] < 0 ? none : mesh.objects[(size_t)regions.object[i]];
        solution.material.push_back(offsetOf(m.name));
        solution.object.push_back(offsetOf(o.name)), solution.group.push_back(offsetOf(o.group));
        solution.reflects.push_back({m.reflects[0], m.reflects[1], m.reflects[2]});
        solution.emits.push_back({m.emits[0], m.emits[1], m.emits[2]});
    }
    lastLap = common::processorSeconds();
}

void SolveTask::show(SolveStep step, float done, float residual) const {
    if (progress) progress(kStepNames[(int)step], done, residual);
}

void SolveTask::lap(SolveStep step) {
    double now = common::processorSeconds();
    report.seconds[(int)step] += now - lastLap;
    lastLap = now;
}

void SolveTask::setGeometry(const std::vector<Cell> &cells, const std::vector<Texel> &texels) {
    solution.charts = regions.charts, solution.facets = regions.facets;
    solution.cells = cells, solution.texels = texels;
    pictured.compute(mesh, regions.chartOf, regions.charts, cells, report.notes);
    solution.cellReflects = pictured.ofCell;
    if (!pictured.ofChart.empty()) solution.reflects = pictured.ofChart;
}

float SolveTask::solvedShare(float residual) {
    double now = std::log(std::max((double)residual, 1e-12)), end = std::log((double)settings.residual);
    if (firstResidual == 0) firstResidual = now;
    return (float)std::clamp(firstResidual <= end ? 1 : (firstResidual - now) / (firstResidual - end), 0.,
                             1.);
}

} // namespace odraz::radiosity
