// Answers that need neither window nor hall: to wrong options, to --help and to --version. They are decoded
// first, so that the packed program prints them at once.
#pragma once

#include "options.h"

namespace odraz {

// Reads the options, and answers those that can be answered here. Returns whether there is nothing more to
// do; `status` is the exit status then.
bool answered(int argc, char **argv, bool stdoutClosed, Options &o, int &status);

// Prints the help if the options ask for it, else the version. Returns an exit status.
int printAnswer(const Options &o);

} // namespace odraz
