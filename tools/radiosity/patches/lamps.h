// The lamps of a mesh, for solving between patches.
#pragma once

#include "tools/radiosity/divide/regions.h"

#include "radiosity/direct.h"

namespace odraz::radiosity {

// If lamps have more facets than this, hemicubes find their light better.
inline constexpr size_t kManyLamps = 256;

// The facets that emit, for direct light. The largest has the full number of parts, others fewer by their
// area.
std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples);

} // namespace odraz::radiosity
