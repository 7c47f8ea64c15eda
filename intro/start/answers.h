// Answers that need neither window nor hall: to wrong options, --help and --version. They are decoded first,
// so that the packed program prints them at once.
#pragma once

#include "options.h"

namespace odraz {

// Reads the options, and prints the answers that need nothing else. Returns whether the program is done;
// `status` is its exit status then.
bool answered(int argc, char **argv, bool stdoutClosed, Options &o, int &status);

// Prints the help if --help was given, else the version. Returns an exit status.
int printAnswer(const Options &o);

} // namespace odraz
