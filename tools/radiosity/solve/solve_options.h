// The options for reading, lighting and solving a model.
#pragma once

#include "tools/common/command_line.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace odraz::radiosity {

// The radiance of an even sky, if that is the value of --sky. Throws Refused if it is out of range.
std::optional<Rgb> evenRadiance(const std::string &sky);

class SolveOptions {
public:
    // kSolve has all options. kView lacks --progress, and --sky and --up, which `view` defines itself.
    // kTransfer has those for solving by rays, for any sky and with all bounces. kStudy lacks those of the
    // method, which `study` varies.
    enum class For { kSolve, kView, kTransfer, kStudy };
    void addTo(common::CommandLine &line, For command);
    // The groups of these options in --help.
    static const std::vector<std::string> &groups();

    // Call it after parse(): chooses the method, reads the sky, suns and lamps. Throws Refused.
    void finish(const common::CommandLine &line);
    // Adds the suns and lamps of a model to those of the options; with --sun only the lamps. The sky's notes
    // are added, too.
    void addLights(const Mesh &mesh, Surroundings &to, std::vector<std::string> &notes) const;

    ReadSettings read;
    SolveSettings settings;
    bool upIsZ = false;
    std::string sky;       // the value of --sky
    bool progress = false; // report in lines if stderr is not a terminal

private:
    std::vector<std::string> suns, lamps, skyNotes;
    double megabytes = 8192;
};

} // namespace odraz::radiosity
