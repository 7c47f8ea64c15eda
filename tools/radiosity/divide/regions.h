// Turns triangles into charts. Neighbours in one plane and of one material are joined into regions, and each
// region becomes a chart. If a region consists of rectangles, these are its facets; otherwise its triangles
// are.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// The charts and facets of a mesh, in lists of any length.
struct Regions {
    std::vector<Chart> charts; // not divided into patches
    std::vector<Facet> facets;
    std::vector<int> material; // of each chart, index into Mesh::materials
    std::vector<int> chartOf;  // of each triangle
    std::vector<float> off;    // for each chart: the largest distance of a corner from its plane
};

// Cells have sides of about `cell`. Throws ModelError if there are too many materials.
Regions joinRegions(const Mesh &mesh, double cell);

// Copies the regions into an empty model. Throws ModelError if they do not fit.
void fillModel(Model &model, const Regions &regions);

} // namespace odraz::radiosity
