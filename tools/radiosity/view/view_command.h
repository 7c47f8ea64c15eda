// `radiosity view`: a window to fly through a model, solved or being solved.
#pragma once

#include "tools/common/arguments.h"

namespace odraz::radiosity {

// Runs `view` with the words that follow it. Throws Refused, or std::runtime_error. Returns the exit status.
int runView(common::Arguments &words);

} // namespace odraz::radiosity
