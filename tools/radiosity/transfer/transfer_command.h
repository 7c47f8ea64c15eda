// `radiosity transfer`: solves a model for all lights, and writes a room that can be relit.
#pragma once

#include "tools/common/command_line.h"

namespace odraz::radiosity {

// Runs `transfer` with its command line. Throws Refused, or std::runtime_error. Returns the exit
// status.
int runTransfer(common::CommandLine &line);

} // namespace odraz::radiosity
