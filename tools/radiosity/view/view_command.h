// `radiosity view`: a window to fly through a model, solved or being solved.
#pragma once

#include "tools/common/command_line.h"

namespace odraz::radiosity {

// Runs `view` with its command line. Throws Refused, or std::runtime_error. Returns the exit status.
int runView(common::CommandLine &line);

} // namespace odraz::radiosity
