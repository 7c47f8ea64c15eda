// `radiosity render`: a picture of a solution.
#pragma once

#include "tools/common/command_line.h"

namespace odraz::radiosity {

// Runs `render` with its command line. Throws Refused, or std::runtime_error. Returns the exit
// status.
int runRender(common::CommandLine &line);

} // namespace odraz::radiosity
