#include "tools/measure/oracle/model_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odraz {

using namespace radiosity;

namespace {

// The one or two triangles of a facet
std::vector<Obstacles::Triangle> trianglesOf(const Model &m, int facet) {
    const Facet &f = m.facets[facet];
    const Chart &c = m.charts[f.chart];
    Vec3d corner[4];
    for (int k = 0; k < 4; ++k) corner[k] = toDouble(f.corner(c, k));
    std::vector<Obstacles::Triangle> triangles = {{corner[0], corner[1], corner[2]}};
    if (!f.triangle()) triangles.push_back({corner[0], corner[2], corner[3]});
    return triangles;
}

// The triangles of all facets, and the chart of each
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

ModelRays::ModelRays(const Model &model) : model(model), obstacles(trianglesOf(model, chartOf)) {}

Vec3d before(const Chart &chart, Vec3 p) { return toDouble(p) + toDouble(chart.n) * (double)chart.off(); }

int ModelRays::castFan(const Chart &from, Vec3 p, int side, uint32_t seed,
                       const std::function<void(int chart, Vec3 at, Vec3 d)> &met) const {
    Sampler sampler(seed);
    Vec3d origin = before(from, p), n = toDouble(from.n);
    int backs = 0;
    for (int k = 0; k < side * side; ++k) {
        Vec3d d = byCosine(n, inCell(sampler, k, side));
        Obstacles::Hit hit = obstacles.nearest(origin, d);
        if (hit.back)
            ++backs;
        else if (hit.met())
            met(chartOf[(size_t)hit.number], toFloat(origin + d * hit.t), toFloat(d));
        else
            met(-1, {}, toFloat(d));
    }
    return backs;
}

double ModelRays::facetFormFactor(int facet, const Chart &from, Vec3 p, int side, uint32_t seed) const {
    Sampler sampler(seed);
    Vec3d origin = before(from, p), here = toDouble(from.n),
          there = toDouble(model.charts[model.facets[facet].chart].n);
    double factor = 0;
    for (const Obstacles::Triangle &t : trianglesOf(model, facet)) {
        double area = length(cross(t[1] - t[0], t[2] - t[0])) / 2, sum = 0;
        for (int k = 0; k < side * side; ++k) {
            Vec3d to = onTriangle(t, inCell(sampler, k, side)) - origin;
            double far = length(to), kernel = std::max(0., dot(to, here)) * std::max(0., -dot(to, there));
            if (kernel > 0 && !obstacles.blocked(origin, to / far, far * 0.9999))
                sum += kernel / (far * far * far * far);
        }
        factor += sum * area / (std::numbers::pi * side * side);
    }
    return factor;
}

RowFinder rowsByRays(int side) {
    return [side](const Model &m, const Scene &, const uint8_t *lit, Workers &workers, Arena &arena,
                  FormFactors &factors, const Progress &) {
        ModelRays rays(m);
        std::vector<FoundRow> rows((size_t)m.patchCount);
        parallelFor(workers, m.patchCount, [&](int i, int) {
            const Patch &p = m.patches[i];
            if (p.share == 0 || !lit[i]) return;
            std::vector<uint32_t> met;
            rays.castFan(m.charts[p.chart], p.p, side, (uint32_t)i, [&](int chart, Vec3 at, Vec3) {
                if (chart >= 0) met.push_back(patchAt(m, chart, at));
            });
            std::sort(met.begin(), met.end());
            FoundRow &found = rows[(size_t)i];
            for (size_t k = 0; k < met.size();) {
                size_t end = k;
                while (end < met.size() && met[end] == met[k]) ++end;
                if (lit[met[k]]) found.links.push_back({met[k], (float)(end - k) / (float)(side * side)});
                k = end;
            }
            found.known = true;
        });
        keepRows(rows, arena, factors);
        return !workers.aborted();
    };
}

} // namespace odraz
