// Runs other programs: the compiler, which links, and the packer.
#pragma once

#include <string>
#include <vector>

namespace pack::linking {

using Words = std::vector<std::string>;

struct Outcome {
    int status;       // as a shell tells it: 128 and the signal's number for a program that a signal ended
    std::string said; // on both outputs, if it was kept
};

// Waits for the command to end. Its outputs are kept, or they are ours. With `tell` the command is printed
// first, on stderr. Throws std::runtime_error if a signal asks this program to end meanwhile (catchSignals),
// and common::Refused if there is no such program.
Outcome runKept(const Words &command, bool tell);
Outcome runShown(const Words &command, bool tell);

// From now on SIGINT, SIGTERM and SIGHUP end the program that runs, and then this one by an exception, so
// that no temporary file stays. During runShown SIGINT is left to the program that runs.
void catchSignals();

// The folder that this program lies in, to find others beside it; empty if the system does not tell.
std::string ownFolder();

} // namespace pack::linking
