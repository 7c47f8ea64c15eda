// From triangles to what radiosity works on: neighbours in one plane and of one material are joined to
// regions, each a chart; regions that are made of rectangles become few of them.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/mesh.h"

namespace odraz {

// As many charts and facets as a mesh has.
struct Regions {
    std::vector<Chart> charts; // none of them divided into patches
    std::vector<Facet> facets;
    std::vector<int> material; // of each chart, index into Mesh::materials
    std::vector<int> chartOf;  // of each triangle
    double off = 0;            // how far from its chart's plane a corner may lie
};

// Cells have sides of about `cell`. Throws ModelError for too many materials.
Regions joinRegions(const Mesh &mesh, double cell);

// Puts them into an empty model. Throws ModelError where there is no room.
void fillModel(Model &model, const Regions &regions);

// Adds all facets of a model to a scene, as its material 0.
void poseFacets(const Model &model, Scene &scene);

} // namespace odraz
