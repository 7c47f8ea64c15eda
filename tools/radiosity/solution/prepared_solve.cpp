// The data of a solution that are kept for solutions with other materials.
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/solve_task.h"

#include <algorithm>

namespace odraz::radiosity {

std::string SolveTask::prepare(const DirectShares &direct, std::span<const Chart> charts,
                               std::span<const Facet> facets) const {
    std::string to;
    direct.save(to);
    put(to, charts, facets, regions.material);
    return to;
}

PreparedSolve::PreparedSolve(std::string_view from, size_t materials) {
    size_t at = 0;
    bool good = direct.restore(from, at, materials) &&
                get(from, at, regions.charts, regions.facets, regions.material) &&
                regions.material.size() == regions.charts.size() &&
                std::all_of(regions.material.begin(), regions.material.end(),
                            [&](int m) { return m >= 0 && (size_t)m < materials; });
    if (!good) refuseResumed();
    rest = from.substr(at);
}

bool PreparedSolve::fits(const std::vector<int> &emitters) const {
    // The method for lamps depends on all of them
    return direct.seen ? emitters == direct.emitters
                       : std::includes(direct.emitters.begin(), direct.emitters.end(), emitters.begin(),
                                       emitters.end());
}

bool SolveTask::preparable() const {
    return solution.cellReflects.empty() && settings.finalRays == 0 &&
           emitters().size() <= DirectShares::kMost;
}

std::vector<Rgb> SolveTask::emitted() const {
    std::vector<Rgb> all;
    for (const MeshMaterial &m : mesh.materials) all.push_back({m.emits[0], m.emits[1], m.emits[2]});
    return all;
}

std::vector<int> SolveTask::emitters() const {
    std::vector<int> all;
    for (size_t i = 0; i < regions.material.size(); ++i)
        if (maxComponent(solution.emits[i]) > 0) all.push_back(regions.material[i]);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace odraz::radiosity
