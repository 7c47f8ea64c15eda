// Files kept beside a solution. OUT.state has the rows (form factors) found so far; solving continues from it
// and ends with the same bytes. OUT.rows is for solutions with other emissions or reflectances. It has
// everything that does not depend on them: all rows, the divided model, and direct light from lamps of
// radiance 1.
#pragma once

#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace odraz::radiosity {

struct Kept {
    enum class Kind { kState, kRows };

    Kept() = default;
    // Reads a file. Throws Refused, with the file's name first, if it is of another kind, damaged or from
    // another version.
    Kept(const std::string &path, Kind kind);
    Kept(const Kept &) = delete;
    // Writes beside `path` and renames. Throws std::runtime_error.
    void save(const std::string &path, Kind kind) const;

    std::vector<std::string> words; // of the command, after `solve`
    uint64_t model = 0;             // checksum: for a state sumOf() the model, for rows sumOfFile()
    std::string_view rows;          // as SolveSettings::keep gets them

    // Of rows alone
    uint64_t sky = 0;      // checksum of the sky's picture
    uint64_t solution = 0; // the checksum in the head of the solution's file
    bool evenSky = false;  // an even sky was added, because nothing emitted light
    MaterialNames names;
    std::vector<Vec3> place;   // one: Mesh::place
    std::string_view prepared; // a PreparedSolve; empty: the model must be divided again

private:
    common::WholeFile file; // `rows` and `prepared` point into it, if it was read
};

// Checksums: of the points, triangles, materials with their pictures, and sky; of the sky; of a file and
// others beside it. The last throws Refused if one cannot be read.
uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky);
uint64_t sumOf(const SkyPicture &sky);
uint64_t sumOfFile(const std::string &path, const std::vector<std::string> &parts = {});

} // namespace odraz::radiosity
