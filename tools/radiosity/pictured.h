// What surfaces with a picture reflect: every element the mean of the texels that lie in it.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/mesh.h"

#include <span>

namespace odraz {

struct Pictured {
    std::vector<Rgb> ofCell, ofChart; // both empty where no material has a picture that can be read

    // Where cells are divided on, once more. `chartOf`: of each of the mesh's triangles. What cannot be read
    // is told in notes, and such materials reflect Kd.
    void find(const Mesh &mesh, const std::vector<int> &chartOf, std::span<const Chart> charts,
              std::span<const Cell> cells, std::vector<std::string> &notes);
    // To all patches what they reflect: the mean of their cells.
    void toPatches(Model &model) const;
};

} // namespace odraz
