// OUT.state, saved next to a solution that was stopped: the rows (form factors) found so far. A run that
// resumes from it ends with the same bytes as an uninterrupted run.
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
    // Reads a file. Throws Refused, with the file's name first, if it is damaged or not of this version.
    explicit SavedState(const std::string &path);
    SavedState(const SavedState &) = delete;
    // Writes a temporary file next to `path` and renames it. Throws std::runtime_error.
    void save(const std::string &path) const;

    std::vector<std::string> words; // the command's arguments after `solve`
    uint64_t model = 0;             // sumOf() the model
    std::string_view rows;          // as SolveSettings::keep gets them

private:
    std::string file; // the file that was read, which `rows` points into
};

// The checksum of the points, triangles, materials with their pictures, and sky.
uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky);

} // namespace odraz::radiosity
