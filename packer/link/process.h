// Runs other programs: the compiler, which links, and the packer.
#pragma once

#include <string>
#include <vector>

namespace pack::linking {

using Words = std::vector<std::string>; // a command, or a part of one

struct Outcome {
    int status;         // as in a shell: 128 plus the signal's number if a signal ended it
    std::string output; // on stdout and stderr, if it was kept
};

enum class Output { kKept, kShown };

// Runs a command and waits for its end. With `verbose` it first prints the command on stderr. Throws
// common::Refused if there is no such program. If SIGINT, SIGTERM or SIGHUP comes meanwhile (blockSignals),
// it ends the command and throws std::runtime_error; but with kShown the command handles SIGINT itself.
Outcome run(const Words &command, Output output, bool verbose);

// From now on SIGINT, SIGTERM and SIGHUP take effect only in run(), so that no temporary file is left over.
void blockSignals();

} // namespace pack::linking
