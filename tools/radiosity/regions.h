// From triangles to what radiosity works on: neighbours in one plane and of one material are joined to
// regions, each a chart; regions that are made of rectangles become few of them.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/mesh.h"

namespace odraz {

struct Regions {
    std::vector<int> material; // of each chart, index into Mesh::materials
};

// Adds all facets of a model to a scene, as its material 0.
void poseFacets(const Model &model, Scene &scene);

// Adds the mesh to an empty model. Cells have sides of about `cell`. Throws ModelError where there is no
// room.
Regions addRegions(const Mesh &mesh, Model &model, double cell);

} // namespace odraz
