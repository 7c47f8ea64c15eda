// Runs other programs: the compiler, which links, and the packer.
#pragma once

#include <string>
#include <vector>

namespace pack::linking {

using Words = std::vector<std::string>; // a command, or a part of one

struct Outcome {
    int status;         // as a shell's: 128 and the signal's number for a program that a signal ended
    std::string output; // on stdout and stderr, if it was kept
};

enum class Output { kKept, kShown };

// Waits for the command to end. With `verbose` the command is printed first, on stderr. Throws
// common::Refused if there is no such program, and std::runtime_error if a signal asks this program to end
// meanwhile (blockSignals); the command is ended then, too. SIGINT is left to a command that is shown.
Outcome run(const Words &command, Output output, bool verbose);

// From now on SIGINT, SIGTERM and SIGHUP have an effect in run() alone, so that no temporary file stays.
void blockSignals();

} // namespace pack::linking
