// `radiosity study`: measures the methods on a model, and writes a page about it.
#pragma once

#include "tools/common/command_line.h"

namespace odraz::radiosity {

// Runs `study` with its command line. Throws Refused, or std::runtime_error. Returns the exit status.
int runStudy(common::CommandLine &line);

} // namespace odraz::radiosity
