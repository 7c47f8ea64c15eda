// Reflectance from pictures: an element reflects the mean of the texels inside it.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/read/mesh.h"

#include <span>

namespace odraz::radiosity {

struct ElementReflectance {
    std::vector<Rgb> ofCell, ofChart; // both empty if no material has a readable picture

    // `chartOf` has the chart of each triangle of the mesh. Adds a note for a picture that cannot be read;
    // its materials reflect Kd.
    void find(const Mesh &mesh, const std::vector<int> &chartOf, std::span<const Chart> charts,
              std::span<const Cell> cells, std::vector<std::string> &notes);
    // Sets each patch's reflectance to the mean of its cells.
    void toPatches(Model &model) const;
};

} // namespace odraz::radiosity
