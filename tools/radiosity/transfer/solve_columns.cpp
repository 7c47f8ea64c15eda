#include "tools/radiosity/transfer/solve_columns.h"

#include "tools/radiosity/solution/solve_task.h"

#include <algorithm>

namespace odraz::radiosity {

namespace {

constexpr int kMostColumnSweeps = 1000;

size_t paddedColumns(int lights) {
    return (size_t)(3 * lights + kSolveBlock - 1) / (size_t)kSolveBlock * (size_t)kSolveBlock;
}

} // namespace

size_t ColumnSystem::bytesFor(size_t sites, size_t links, int lights) {
    return sites * (5 * paddedColumns(lights) * sizeof(float) + sizeof(Row)) + links * sizeof(Link) + 4096;
}

ColumnSystem::ColumnSystem(const RaySystem &rays, const std::vector<Rgb> &reflects, int lights, size_t most)
    : memory(4 * reflects.size() * paddedColumns(lights) * sizeof(float) + 4096) {
    size_t sites = reflects.size(), bytes = bytesFor(sites, rays.rows.size(), lights);
    if (bytes > most) refuseMemory(bytes, most, "larger elements, fewer rays or fewer bands need less");
    // Several rays may hit one site
    std::vector<size_t> firsts;
    std::vector<uint32_t> row;
    links.reserve(rays.rows.size());
    for (size_t i = 0; i < sites; ++i) {
        row.assign(rays.rows.begin() + (ptrdiff_t)rays.firstOf[i],
                   rays.rows.begin() + (ptrdiff_t)rays.firstOf[i + 1]);
        std::sort(row.begin(), row.end());
        float share = 1 / (float)row.size();
        firsts.push_back(links.size());
        for (uint32_t site : row) {
            if (site == RaySystem::kDark) break; // the greatest number
            if (links.size() > firsts[i] && links.back().patch == site)
                links.back().share += share;
            else
                links.push_back({site, share});
        }
    }
    firsts.push_back(links.size());
    for (size_t i = 0; i < sites; ++i)
        rows.push_back({links.data() + firsts[i], (int)(firsts[i + 1] - firsts[i]), true});
    factors = {links.data(), rows.data(), links.size(), links.size()};
    makeSystem(system, memory.arena, factors, (int)sites, 3 * lights); // its memory is enough
    sources.resize(sites * (size_t)system.columns);
    for (size_t i = 0; i < sites; ++i)
        for (int k = 0; k < lights; ++k) {
            float *to = system.reflectance + i * (size_t)system.columns + 3 * k;
            to[0] = reflects[i].x, to[1] = reflects[i].y, to[2] = reflects[i].z;
        }
}

void ColumnSystem::solve(float residual, Workers &workers) {
    for (size_t k = 0; k < sources.size(); ++k) system.direct[k] += sources[k];
    odraz::solve(system, workers, residual, kMostColumnSweeps);
    findIndirect(system, workers);
    for (size_t k = 0; k < sources.size(); ++k) sources[k] += system.indirect[k];
}

} // namespace odraz::radiosity
