// The command-line options for reading, lighting and solving a model.
#pragma once

#include "tools/common/command_line.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace odraz::radiosity {

// The radiance of an even sky if the value of --sky is R,G,B. Throws Refused if that is out of range.
std::optional<Rgb> evenRadiance(const std::string &sky);

class SolveOptions {
public:
    // kSolve: all options. kView: all except --progress, and --sky and --up, which `view` defines itself.
    // kTransfer: only the options for solving by rays, for any sky and with all bounces. kStudy: all except
    // the options of the method, which `study` varies.
    enum class For { kSolve, kView, kTransfer, kStudy };
    void addTo(common::CommandLine &line, For command);
    // The groups of these options in --help.
    static const std::vector<std::string> &groups();

    // Chooses the method, and reads the sky, suns and lamps. Call it after parse(). Throws Refused.
    void finish(const common::CommandLine &line);
    // Adds the model's lamps, its suns unless --sun was given, and the notes on the sky.
    void addLights(const Mesh &mesh, Surroundings &to, std::vector<std::string> &notes) const;

    ReadSettings read;
    SolveSettings settings;
    bool upIsZ = false;
    std::string sky;       // the value of --sky
    bool progress = false; // report progress in lines if stderr is not a terminal

private:
    std::vector<std::string> suns, lamps, skyNotes;
    double megabytes = 8192;
};

} // namespace odraz::radiosity
