// `radiosity solve`: finds a model's light while a bar grows, and saves it in a file.
#pragma once

#include "tools/common/command_line.h"

namespace odraz::radiosity {

// Runs `solve` with its command line. Throws Refused, or std::runtime_error. Returns the exit status.
int runSolve(common::CommandLine &line);

} // namespace odraz::radiosity
