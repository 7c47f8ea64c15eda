// The lamps of a mesh, for solving between patches.
#pragma once

#include "tools/radiosity/divide/regions.h"

#include "radiosity/direct.h"

namespace odraz::radiosity {

// If lamps have more facets than this, hemicubes are the better way to find their light.
inline constexpr size_t kManyLamps = 256;

// The facets that emit, for direct light. The largest has `samples` parts, others fewer in proportion to
// their area.
std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples);

} // namespace odraz::radiosity
