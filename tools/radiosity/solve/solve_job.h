// The command line of `radiosity solve`.
#pragma once

#include "tools/radiosity/solution/kept.h"
#include "tools/radiosity/solve/solve_options.h"

#include <memory>

namespace odraz::radiosity {

struct SolveJob {
    // Reads the words after `solve`. Throws Refused.
    explicit SolveJob(std::vector<std::string> words);
    SolveJob(const SolveJob &) = delete;

    common::CommandLine line;
    std::string model, out;
    std::string relight;   // a solution whose rows to use
    std::string resume;    // a state to continue from
    double keepEvery = 60; // seconds
    bool keepRows = false;
    SolveOptions options;
    std::unique_ptr<Kept> kept; // rows to start from: of `resume` or `relight`; null: none
};

// The file of a solution's rows.
inline std::string rowsFile(const std::string &solution) { return solution + ".rows"; }

// Reads a command, or the one in the state that it resumes, and the rows that it uses. A job that relights
// takes the options with which the rows were found. Throws Refused, or std::runtime_error, also if the rows
// belong to another model or solution.
std::unique_ptr<SolveJob> readJob(const std::vector<std::string> &words);

} // namespace odraz::radiosity
