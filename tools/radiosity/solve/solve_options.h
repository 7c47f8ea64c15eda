// The options that say how to read, light and solve a model, for `solve` and for `view` of a model.
#pragma once

#include "tools/common/arguments.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

class SolveOptions {
public:
    // Whether it is one of these options; if so, takes its value. Throws Refused.
    bool take(const std::string &option, common::Arguments &words);
    // Call it after the last option: reads the sky, suns and lamps. Throws Refused.
    void finish();
    // For kept rows, in the file of that name: takes everything from the options that they were found with,
    // except other materials and when to stop. Throws Refused if one that was given differs.
    void follow(const SolveOptions &kept, const std::string &file);

    bool stopsAlike = false; // after follow(): at the same residual or bounce as the kept solution

    ReadSettings read;
    SolveSettings settings;
    bool upIsZ = false;

private:
    std::vector<std::string> given; // the names of all options
    bool has(const std::string &option) const;
    std::string tell(const std::string &option) const; // with its value, which it has by default, too
    std::string sky, byRays, byPatches;                // the last option for each way
    std::vector<std::string> suns, lamps;
};

} // namespace odraz::radiosity
