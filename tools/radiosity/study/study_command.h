// `radiosity study`: measures the methods on a model, and writes a page about it.
#pragma once

#include "tools/common/arguments.h"

namespace odraz::radiosity {

// Runs `study` with the words that follow it. Throws Refused, or std::runtime_error. Returns the exit status.
int runStudy(common::Arguments &words);

} // namespace odraz::radiosity
