// Solves for many lights at once: converts the sites' rows of rays (rays/ray_system.h) to form factors for
// the film's solver (radiosity/solve.h), which takes any number of right-hand sides.
#pragma once

#include "radiosity/solve.h"
#include "tools/radiosity/rays/ray_system.h"
#include "tools/support/heap_arena.h"

#include <algorithm>
#include <vector>

namespace odraz::radiosity {

// The columns are red, green and blue of each light: column 3 * light + channel.
class ColumnSystem {
public:
    // `reflects`: the sites' reflectance.
    ColumnSystem(const RaySystem &rays, const std::vector<Rgb> &reflects, int lights)
        : memory(4 * reflects.size() * paddedColumns(lights) * sizeof(float) + 4096) {
        size_t sites = reflects.size();
        // Add the shares of rays that hit the same site
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
                if (site == RaySystem::kDark) break; // sorted: the rest are kDark
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
    ColumnSystem(const ColumnSystem &) = delete;

    int columns() const { return system.columns; } // a multiple of kSolveBlock
    // A site's direct light, irradiance / pi, in all columns. Set it before solve(): `source` is the light
    // that rays find, which is later shared between neighbours; `direct` is the rest.
    float *source(size_t site) { return &sources[site * (size_t)system.columns]; }
    float *direct(size_t site) { return system.direct + site * (size_t)system.columns; }

    // Solves until a sweep changes the light by less than the residual.
    void solve(float residual, Workers &workers) {
        for (size_t k = 0; k < sources.size(); ++k) system.direct[k] += sources[k];
        odraz::solve(system, workers, residual, kMostColumnSweeps);
        findIndirect(system, workers);
        for (size_t k = 0; k < sources.size(); ++k) sources[k] += system.indirect[k];
    }

    // After solve(): the light that arrives along the sites' rays, without `direct`.
    const float *arrives() const { return sources.data(); }
    // After solve(): the radiance that a site reflects.
    const float *reflected(size_t site) const { return system.radiosity + site * (size_t)system.columns; }

    static size_t bytesFor(size_t sites, size_t links, int lights) {
        return sites * (5 * paddedColumns(lights) * sizeof(float) + sizeof(FormFactorRow)) +
               links * sizeof(Link) + 4096;
    }

private:
    static constexpr int kMostColumnSweeps = 1000;
    static size_t paddedColumns(int lights) {
        return (size_t)(3 * lights + kSolveBlock - 1) / (size_t)kSolveBlock * (size_t)kSolveBlock;
    }

    HeapArena memory;
    std::vector<Link> links;
    std::vector<FormFactorRow> rows;
    FormFactors factors = {};
    System system = {};
    std::vector<float> sources;
};

} // namespace odraz::radiosity
