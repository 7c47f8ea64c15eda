// `radiosity solve`: finds a model's light while a bar grows, and saves it in a file.
#pragma once

#include "tools/common/arguments.h"

namespace odraz::radiosity {

// Runs `solve` with the words that follow it. Throws Refused, or std::runtime_error. Returns the exit status.
int runSolve(common::Arguments &words);

} // namespace odraz::radiosity
