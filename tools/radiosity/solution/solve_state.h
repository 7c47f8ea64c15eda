// The state of a stopped solution, as a file beside it: the words of its command, the checksum of its model,
// and the rows found so far. Solving continues from there and gives the same bytes.
#pragma once

#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"

#include <cstdint>
#include <string>
#include <vector>

namespace odraz::radiosity {

struct SolveState {
    std::vector<std::string> words; // of the command, after `solve`
    uint64_t model = 0;             // its sumOf()
    std::string rows;               // as SolveSettings::keep receives them

    // Writes beside `path` and renames. Throws std::runtime_error.
    void save(const std::string &path) const;
    // Throws Refused if the file is of another kind or damaged.
    static SolveState read(const std::string &path);
};

// A checksum of the points, triangles, materials with their pictures, and sky.
uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky);

// Of the sky alone.
uint64_t sumOf(const SkyPicture &sky);

} // namespace odraz::radiosity
