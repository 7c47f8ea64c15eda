// Functions that all writers share: they check an output, write it, and report why it cannot be written.
//
// An output is a path, or "-" for standard output. Every function here returns an exit status: 0, or the
// status of a failure, which it has reported in one line on standard error.
#pragma once

#include <stddef.h>

namespace odraz {

// Reports that `what` cannot be written, and why. Returns 1.
int cannotWrite(const char *what, const char *why);

// Checks whether an output can be written. Standard output passes if it was not closed at the start and is
// not a terminal. A path always passes.
int checkOutput(const char *to, bool stdoutClosed);

// Writes a whole file, or all of `data` to standard output.
int writeOutput(const char *to, const void *data, size_t size);

} // namespace odraz
