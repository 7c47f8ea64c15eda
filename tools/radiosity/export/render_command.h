// `radiosity render`: a picture of a solution.
#pragma once

#include "tools/common/arguments.h"

namespace odraz::radiosity {

// Runs `render` with the words that follow it. Throws Refused, or std::runtime_error. Returns the exit
// status.
int runRender(common::Arguments &words);

} // namespace odraz::radiosity
