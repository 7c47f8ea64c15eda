// Rays from places of a model. Directions are random by the cosine law, in double
// precision; nothing that ships works this way.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/reference/obstacles.h"
#include "tools/radiosity/reference/sampler.h"

#include <functional>

namespace odraz {

// A model's facets as obstacles for rays. Windows are open.
struct ModelRays {
    explicit ModelRays(const Model &model);

    // Casts side x side rays from a place of a chart by the cosine law, one in each cell of a grid. Calls met
    // for each ray that hits a front or nothing (chart -1). Another seed gives other rays.
    void castFan(const Chart &from, Vec3 p, int side, uint32_t seed,
                 const std::function<void(int chart, Vec3 at, Vec3 d)> &met) const;
    std::vector<int> chartOf;       // of each triangle
    radiosity::Obstacles obstacles; // the triangles
};

} // namespace odraz
