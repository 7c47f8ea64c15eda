// Faces that overlap in one plane and face the same way. Which of them a ray hits would depend on rounding,
// so the first one in the file is in front: what it covers is cut out of the others.
#pragma once

#include "tools/radiosity/read/mesh.h"

#include <set>

namespace odraz::radiosity {

using PolygonPair = std::pair<int, int>; // the one in front, the one behind

// Cuts a mesh, and returns the polygons that overlapped. `polygonOf` has the polygon of each triangle; those
// of one polygon do not overlap unless its number is negative. Afterwards it fits the new triangles.
// Distances below `tiny` count as zero. The time for N triangles, P pairs of which overlap, is about
// N log N + P.
std::set<PolygonPair> cutOverlaps(Mesh &mesh, std::vector<int> &polygonOf, double tiny);

} // namespace odraz::radiosity
