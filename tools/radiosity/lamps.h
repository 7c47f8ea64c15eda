// The lamps of a mesh.
#pragma once

#include "tools/radiosity/regions.h"

#include "radiosity/direct.h"

namespace odraz {

// Lamps of more facets than these are better seen by hemicubes.
inline constexpr size_t kManyLamps = 256;

// What shines, for direct light. The largest facet has so many parts, others fewer by their area.
std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples);

} // namespace odraz
