#include "tools/radiosity/lamps.h"

#include <algorithm>
#include <cmath>

namespace odraz {

static double areaOf(const Facet &f) {
    double twice = 0;
    for (int k = 0; k < 4; ++k)
        twice += (double)f.u[k] * (double)f.v[(k + 1) & 3] - (double)f.u[(k + 1) & 3] * (double)f.v[k];
    return twice / 2;
}

std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples) {
    std::vector<Glow> glows;
    double largest = 0;
    for (int i = 0; i < model.facetCount; ++i) {
        const auto &e = mesh.materials[(size_t)regions.material[(size_t)model.facets[i].chart]].emits;
        if (e[0] + e[1] + e[2] == 0) continue;
        glows.push_back({i, 1, {e[0], e[1], e[2]}});
        largest = std::max(largest, areaOf(model.facets[i]));
    }
    for (Glow &g : glows)
        g.cells = std::max(1, (int)std::lround(samples * areaOf(model.facets[g.facet]) / largest));
    return glows;
}

} // namespace odraz
