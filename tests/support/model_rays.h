// Rays from points on a model's charts, with random directions by the cosine law, in double precision.
// Nothing that ships works this way.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/reference/obstacles.h"
#include "tools/radiosity/reference/sampler.h"

namespace odraz {

// A model's facets as obstacles for rays. Windows are no obstacles.
struct ModelRays {
    explicit ModelRays(const Model &model);

    // Casts side x side rays from the point p of a chart, one in each cell of a grid. Calls `met` for each
    // ray that hits the front of a facet, or nothing (chart -1). Another seed gives other rays.
    void castFan(const Chart &from, Vec3 p, int side, uint32_t seed,
                 const std::function<void(int chart, Vec3 at, Vec3 d)> &met) const;
    std::vector<int> chartOf;       // by triangle
    radiosity::Obstacles obstacles; // the triangles
};

} // namespace odraz
