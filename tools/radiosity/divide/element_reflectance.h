// Reflectance of elements from the pictures of their materials: the mean of the texels in an element.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/read/mesh.h"

#include <span>

namespace odraz::radiosity {

struct ElementReflectance {
    std::vector<Rgb> ofCell, ofChart; // both empty if no material has a readable picture

    // Computes both. `chartOf`: the chart of each triangle. Materials whose picture cannot be read reflect
    // Kd.
    void compute(const Mesh &mesh, const std::vector<int> &chartOf, std::span<const Chart> charts,
                 std::span<const Cell> cells, std::vector<std::string> &notes);
    // Sets each patch's reflectance to the mean of its cells.
    void toPatches(Model &model) const;
};

} // namespace odraz::radiosity
