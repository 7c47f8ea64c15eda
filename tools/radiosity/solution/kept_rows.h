// The rows of a solution, form factors, kept in a file beside it (SOLUTION.rows) for solutions with other
// emissions or reflectances: these depend on geometry alone. The file also holds what else a solution needs
// that does not depend on materials: the divided model, and direct light by lamps of radiance 1.
#pragma once

#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace odraz::radiosity {

struct KeptRows {
    // What they belong to
    std::vector<std::string> words; // of the command, after `solve`
    uint64_t model = 0;             // checksum of the model's file
    uint64_t sky = 0;               // of the sky's picture
    uint64_t solution = 0;          // of the solution's file, as its head has it
    bool evenSky = false;           // an even sky was added, because nothing shone
    MaterialNames names;

    // In the form of the way it was solved (rays/, patches/)
    std::string_view rows;     // as SolveSettings::keep gets them
    std::string_view prepared; // a PreparedSolve; empty: the model must be divided again
    std::vector<double> away;  // how far from where it lies the model was solved: three

    // Writes beside `path` and renames. Throws std::runtime_error.
    void save(const std::string &path) const;
    // Throws Refused with a line that begins with the file's name if it is none, damaged or from another
    // version.
    explicit KeptRows(const std::string &path);
    KeptRows() = default;
    KeptRows(const KeptRows &) = delete;

private:
    common::WholeFile file; // rows and prepared lie in it
};

// The checksum of a file. Throws Refused.
uint64_t sumOfFile(const std::string &path);

} // namespace odraz::radiosity
