#include "lamps.h"

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
    std::vector<int> lampAt(mesh.points.size(), -1), parent;
    auto root = [&](int i) {
        while (parent[(size_t)i] != i) i = parent[(size_t)i];
        return i;
    };
    std::vector<int> lampOf(mesh.triangles.size(), -1);
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle &t = mesh.triangles[i];
        const auto &e = mesh.materials[(size_t)t.material].emits;
        if (e[0] + e[1] + e[2] == 0) continue;
        int lamp = (int)parent.size();
        parent.push_back(lamp);
        for (int c : t.corners) {
            int &at = lampAt[(size_t)c];
            if (at >= 0 && mesh.triangles[(size_t)at].material == t.material)
                lamp = parent[(size_t)root(lampOf[(size_t)at])] = root(lamp);
            at = (int)i;
        }
        lampOf[i] = lamp;
    }
    std::vector<double> areas(parent.size());
    auto lampOfFacet = [&](int f) {
        int lamp = lampOf[(size_t)regions.triangle[(size_t)model.facets[f].chart]];
        return lamp < 0 ? -1 : root(lamp);
    };
    double largest = 0;
    for (int i = 0; i < model.facetCount; ++i)
        if (int lamp = lampOfFacet(i); lamp >= 0)
            largest = std::max(largest, areas[(size_t)lamp] += areaOf(model.facets[i]));
    std::vector<double> due(parent.size(), 0.5);
    for (int i = 0; i < model.facetCount; ++i) {
        int lamp = lampOfFacet(i);
        if (lamp < 0) continue;
        double all = areas[(size_t)lamp], parts = std::max(1., samples * all / largest);
        double own = parts * areaOf(model.facets[i]) / all;
        const auto &k = mesh.materials[(size_t)regions.material[(size_t)model.facets[i].chart]].emits;
        Rgb e = {k[0], k[1], k[2]};
        if (own >= 1)
            glows.push_back({i, std::min((int)std::lround(own), kMaxLampCells), e});
        else if ((due[(size_t)lamp] += own) >= 1) {
            --due[(size_t)lamp];
            glows.push_back({i, 1, e * (float)(1 / own)});
        }
    }
    return glows;
}

} // namespace odraz
