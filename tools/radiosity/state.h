// What there is of a solution that was stopped, as a file beside it: the words it was begun with, which model
// it is of, and the rows that were found. It goes on from there, to the same bytes.
#pragma once

#include "tools/radiosity/mesh.h"
#include "tools/radiosity/surroundings.h"

#include <cstdint>
#include <string>
#include <vector>

namespace odraz {

struct SolveState {
    std::vector<std::string> words; // of the command, behind `solve`
    uint64_t model = 0;             // sumOf() it
    std::string rows;               // as BakeSettings::keep has them

    // Written beside and renamed. Throws std::runtime_error.
    void save(const std::string &path) const;
    // Throws Refused where it is none, or damaged.
    static SolveState read(const std::string &path);
};

// The same for the same points, triangles, materials with their pictures, and sky.
uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky);

} // namespace odraz
