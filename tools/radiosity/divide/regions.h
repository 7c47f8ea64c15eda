// Turns triangles into charts. Neighbours of one object and material in one plane are joined into a region,
// which becomes a chart. Its facets are rectangles if the region consists of them, otherwise its triangles.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// The charts and facets of a mesh, in lists of any length.
struct Regions {
    std::vector<Chart> charts; // not divided into patches
    std::vector<Facet> facets;
    std::vector<int> material;    // for each chart: index into Mesh::materials
    std::vector<int> object;      // for each chart: index into Mesh::objects, or -1
    std::vector<int> chartOf;     // for each triangle: its chart
    std::vector<float> deviation; // for each chart: the largest distance of a corner from its plane
};

// Finds the charts. Cells have sides of about `cell`. Throws ModelError for too many materials.
Regions joinRegions(const Mesh &mesh, double cell);

// Copies the regions into an empty model. Throws ModelError if they do not fit.
void fillModel(Model &model, const Regions &regions);

} // namespace odraz::radiosity
