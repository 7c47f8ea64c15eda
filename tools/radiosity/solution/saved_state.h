// OUT.state, kept beside a solution that was stopped: the rows (form factors) found so far. Solving continues
// from it and ends with the same bytes.
#pragma once

#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace odraz::radiosity {

struct SavedState {
    SavedState() = default;
    // Reads a file. Throws Refused, with the file's name first, if it is of another kind, damaged or from
    // another version.
    explicit SavedState(const std::string &path);
    SavedState(const SavedState &) = delete;
    // Writes beside `path` and renames. Throws std::runtime_error.
    void save(const std::string &path) const;

    std::vector<std::string> words; // of the command, after `solve`
    uint64_t model = 0;             // sumOf() it
    std::string_view rows;          // as SolveSettings::keep gets them

private:
    common::WholeFile file; // `rows` point into it, if it was read
};

// The checksum of the points, triangles, materials with their pictures, and sky.
uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky);

} // namespace odraz::radiosity
