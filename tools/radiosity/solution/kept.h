// What is kept of a solution in a file beside it. OUT.state has the rows (form factors) found so far, from
// which solving continues to the same bytes. OUT.rows has all rows, for solutions with other emissions or
// reflectances, since rows depend on geometry alone; and what else these need that does not depend on
// materials: the divided model, and direct light by lamps of radiance 1.
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
    // Reads a file. Throws Refused with a line that begins with its name if it is of another kind, damaged or
    // from another version.
    Kept(const std::string &path, Kind kind);
    Kept(const Kept &) = delete;
    // Writes beside `path` and renames. Throws std::runtime_error.
    void save(const std::string &path, Kind kind) const;

    std::vector<std::string> words; // of the command, after `solve`
    uint64_t model = 0;             // checksum: of a state sumOf() of the model, of rows that of its file
    std::string_view rows;          // as SolveSettings::keep gets them

    // Of rows alone
    uint64_t sky = 0;      // checksum of the sky's picture
    uint64_t solution = 0; // of the solution's file, as its head has it
    bool evenSky = false;  // an even sky was added, because nothing shone
    MaterialNames names;
    std::vector<double> away;  // how far from where it lies the model was solved: three
    std::string_view prepared; // a PreparedSolve; empty: the model must be divided again

private:
    common::WholeFile file; // rows and prepared lie in it, if it was read
};

// A checksum of the points, triangles, materials with their pictures, and sky; of the sky; and of a file,
// which throws Refused if it cannot be read.
uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky);
uint64_t sumOf(const SkyPicture &sky);
uint64_t sumOfFile(const std::string &path);

} // namespace odraz::radiosity
