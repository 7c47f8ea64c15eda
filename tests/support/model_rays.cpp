#include "tests/support/model_rays.h"

namespace odraz {

using namespace radiosity;

namespace {

// Splits a facet into one or two triangles
std::vector<Obstacles::Triangle> trianglesOf(const Model &m, int facet) {
    const Facet &f = m.facets[facet];
    const Chart &c = m.charts[f.chart];
    Vec3d corner[4];
    for (int k = 0; k < 4; ++k) corner[k] = toDouble(f.corner(c, k));
    std::vector<Obstacles::Triangle> triangles = {{corner[0], corner[1], corner[2]}};
    if (!f.triangle()) triangles.push_back({corner[0], corner[2], corner[3]});
    return triangles;
}

// Collects the triangles of all facets, and the chart of each triangle
std::vector<Obstacles::Triangle> trianglesOf(const Model &m, std::vector<int> &chartOf) {
    std::vector<Obstacles::Triangle> all;
    for (int i = 0; i < m.facetCount; ++i) {
        if (m.charts[m.facets[i].chart].open) continue;
        for (const Obstacles::Triangle &triangle : trianglesOf(m, i)) {
            all.push_back(triangle);
            chartOf.push_back(m.facets[i].chart);
        }
    }
    return all;
}

} // namespace

ModelRays::ModelRays(const Model &model) : obstacles(trianglesOf(model, chartOf)) {}

void ModelRays::castFan(const Chart &from, Vec3 p, int side, uint32_t seed,
                        const std::function<void(int chart, Vec3 at, Vec3 d)> &met) const {
    Sampler sampler(seed);
    Vec3d n = toDouble(from.n), origin = toDouble(p) + n * (double)from.off(); // safely in front of the chart
    for (int k = 0; k < side * side; ++k) {
        Vec3d d = byCosine(n, inCell(sampler, k, side));
        Obstacles::Hit hit = obstacles.nearest(origin, d);
        if (hit.back) continue;
        if (hit.met())
            met(chartOf[(size_t)hit.number], toFloat(origin + d * hit.t), toFloat(d));
        else
            met(-1, {}, toFloat(d));
    }
}

} // namespace odraz
