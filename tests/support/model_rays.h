// Rays from points on a model's charts, with random directions by the cosine law, in double precision.
// Nothing that ships works this way.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/reference/obstacles.h"
#include "tools/radiosity/reference/sampler.h"

namespace odraz {

// A model's facets as obstacles for rays. Windows are no obstacles.
struct ModelRays {
    std::vector<int> chartOf; // by triangle
    radiosity::Obstacles obstacles;

    explicit ModelRays(const Model &m) : obstacles(trianglesOf(m)) {}

    // Casts side x side rays from the point p of a chart, one in each cell of a grid. Calls met(chart, at,
    // direction) for each ray that hits the front of a facet, or nothing (chart -1). Another seed gives other
    // rays.
    template <class Met> void castFan(const Chart &from, Vec3 p, int side, uint32_t seed, Met met) const {
        radiosity::Sampler sampler(seed);
        Vec3d n = toDouble(from.n), origin = toDouble(p) + n * (double)from.off(); // safely in front of it
        for (int k = 0; k < side * side; ++k) {
            Vec3d d = byCosine(n, inCell(sampler, k, side));
            radiosity::Obstacles::Hit hit = obstacles.nearest(origin, d);
            if (hit.back) continue;
            if (hit.met())
                met(chartOf[(size_t)hit.number], toFloat(origin + d * hit.t), toFloat(d));
            else
                met(-1, Vec3{}, toFloat(d));
        }
    }

private:
    std::vector<radiosity::Obstacles::Triangle> trianglesOf(const Model &m) {
        std::vector<radiosity::Obstacles::Triangle> all;
        for (int i = 0; i < m.facetCount; ++i) {
            const Facet &f = m.facets[i];
            const Chart &c = m.charts[f.chart];
            for (int k = 2; k < (f.triangle() ? 3 : 4) && !c.open; ++k) {
                auto corner = [&](int at) { return toDouble(f.corner(c, at)); };
                all.push_back({corner(0), corner(k - 1), corner(k)});
                chartOf.push_back(f.chart);
            }
        }
        return all;
    }
};

} // namespace odraz
