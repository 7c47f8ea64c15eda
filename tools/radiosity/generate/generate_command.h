// `radiosity generate`: writes an example model.
#pragma once

#include "tools/common/command_line.h"

namespace odraz::radiosity {

// Runs `generate` with the words that follow it. Throws Refused. Returns the exit status.
int runGenerate(common::CommandLine &line);

} // namespace odraz::radiosity
