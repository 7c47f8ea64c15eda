#include "tools/radiosity/patches/lamps.h"

#include "tools/radiosity/divide/facets.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples) {
    std::vector<Glow> glows;
    double largest = 0;
    for (int i = 0; i < model.facetCount; ++i) {
        const auto &e = mesh.materials[(size_t)regions.material[(size_t)model.facets[i].chart]].emits;
        if (e[0] + e[1] + e[2] == 0) continue;
        glows.push_back({i, 1, {e[0], e[1], e[2]}});
        largest = std::max(largest, areaOf(outlineOf(model.facets[i])));
    }
    for (Glow &g : glows)
        g.cells = std::max(1, (int)std::lround(samples * areaOf(outlineOf(model.facets[g.facet])) / largest));
    return glows;
}

} // namespace odraz::radiosity
