#include "tools/radiosity/rays/site_values.h"

namespace odraz::radiosity {

std::vector<Rgb> meansOfSites(const LightGrid &grid, const std::vector<uint16_t> &behind,
                              const std::vector<Rgb> &texels) {
    std::vector<Rgb> means(grid.sites.size());
    for (size_t i = 0; i < means.size(); ++i) {
        const LightGrid::Site &site = grid.sites[i];
        int count = 0;
        for (uint32_t k = 0; k < site.places; ++k)
            if (!(behind[i] >> k & 1))
                means[i] += texels[(size_t)grid.places[site.firstPlace + k].texel], ++count;
        means[i] = means[i] * (1 / (float)count);
    }
    return means;
}

std::vector<Rgb> reflectanceOfSites(const LightGrid &grid, const Solution &solution) {
    std::vector<Rgb> reflects(grid.sites.size());
    const std::vector<Rgb> &ofCell = solution.cellReflects;
    for (size_t i = 0; i < reflects.size(); ++i) {
        const LightGrid::Site &site = grid.sites[i];
        if (ofCell.empty()) {
            reflects[i] = solution.reflects[(size_t)site.chart];
            continue;
        }
        for (uint32_t k = 0; k < site.places; ++k) {
            auto *cell = grid.spotAt(site.chart, grid.places[site.firstPlace + k].p).cell;
            reflects[i] += ofCell[(size_t)(cell - grid.cells.data())] * (1 / (float)site.places);
        }
    }
    return reflects;
}

} // namespace odraz::radiosity
