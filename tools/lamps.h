// The lamps of a mesh.
#pragma once

#include "regions.h"

#include "radiosity/direct.h"

namespace odraz {

// What shines, for direct light. A lamp is what of one material hangs together. The largest has so many
// parts, others fewer by their area; of facets that are smaller than a part some stand for all.
std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples);

} // namespace odraz
