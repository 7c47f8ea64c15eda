// The options for reading, lighting and solving a model.
#pragma once

#include "tools/common/command_line.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

class SolveOptions {
public:
    // `solve` takes all of them; `view` has --sky and --up of its own. `transfer` solves by rays with all
    // bounces, for any sky. `study` varies the method itself.
    enum class For { kSolve, kView, kTransfer, kStudy };
    void addTo(common::CommandLine &line, For command);
    // The groups of these options in --help.
    static const std::vector<std::string> &groups();

    // Call it after parse(): chooses the method, reads the sky, suns and lamps. Throws Refused.
    void finish(const common::CommandLine &line);
    // For kept rows, in the file of that name, after finish(): takes everything from the options that they
    // were found with, except other materials and when to stop. Throws Refused if one that was given differs.
    void follow(const common::CommandLine &line, const SolveOptions &kept,
                const common::CommandLine &keptLine, const std::string &file);

    bool stopsAlike = false; // after follow(): at the same residual or bounce as the kept solution

    ReadSettings read;
    SolveSettings settings;
    bool upIsZ = false;
    std::string sky;       // the value of --sky
    bool progress = false; // is reported in lines where stderr is no terminal

private:
    std::vector<std::string> suns, lamps;
    double megabytes = 8192;
};

} // namespace odraz::radiosity
