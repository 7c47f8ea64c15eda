// `radiosity transfer`: solves a model for all lights, and writes a room that can be relit.
#pragma once

#include "tools/common/arguments.h"

namespace odraz::radiosity {

// Runs `transfer` with the words that follow it. Throws Refused, or std::runtime_error. Returns the exit
// status.
int runTransfer(common::Arguments &words);

} // namespace odraz::radiosity
