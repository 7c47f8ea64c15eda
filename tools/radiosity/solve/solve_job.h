// What `radiosity solve` was asked to do.
#pragma once

#include "tools/radiosity/solution/kept_rows.h"
#include "tools/radiosity/solution/solve_state.h"
#include "tools/radiosity/solve/solve_options.h"

#include <memory>

namespace odraz::radiosity {

struct SolveJob {
    // Reads a command line, without the word `solve`. Throws Refused.
    explicit SolveJob(std::vector<std::string> words);
    SolveJob(const SolveJob &) = delete;

    common::CommandLine line;
    std::string model, out;
    std::string relight;   // a solution whose rows are used
    std::string resume;    // a state to continue from
    double keepEvery = 60; // seconds
    bool keepRows = false;
    bool progress = false; // in lines, where stderr is no terminal
    SolveOptions options;
};

// The file of a solution's rows.
inline std::string rowsFile(const std::string &solution) { return solution + ".rows"; }

// Reads a new command, or the one of the state that it resumes. Throws Refused.
std::unique_ptr<SolveJob> beginJob(const std::vector<std::string> &words, SolveState &state);

// Finds the rows that a job uses, and takes its options from theirs. Throws Refused, or std::runtime_error,
// if they do not belong to its model or solution.
std::unique_ptr<KeptRows> findRows(SolveJob &job);

} // namespace odraz::radiosity
