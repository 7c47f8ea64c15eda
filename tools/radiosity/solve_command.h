// `radiosity solve`: a model's light, found while a bar grows, and kept in a file.
#pragma once

#include "tools/common/arguments.h"

namespace odraz {

// The words behind `solve`. Throws Refused, or std::runtime_error. Returns the exit status.
int runSolve(Arguments &words);

} // namespace odraz
