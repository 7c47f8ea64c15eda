// Runs other programs: the compiler, which links, and objdump.
#pragma once

#include <string>
#include <vector>

namespace pack {

using Words = std::vector<std::string>; // a command, or a part of one

struct Outcome {
    int status;         // as in a shell: 127 if there is no such program, 128 plus a signal's number
    std::string output; // on stdout and stderr
};

// Runs a command and waits for its end. Throws std::runtime_error if no process can be started.
Outcome run(const Words &command);

// Ends the command that runs, for handlers of signals.
void endRunning();

} // namespace pack
