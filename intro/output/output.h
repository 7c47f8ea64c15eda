// What all writers share: whether an output can be written at all, writing it, and saying why it was not.
//
// An output is a path, or "-" for standard output. Every function here returns an exit status: 0, or that of
// a failure, which has then been reported in one line on standard error.
#pragma once

#include <stddef.h>

namespace odraz {

// Complains that `what` cannot be written, and why; returns 1.
int cannotWrite(const char *what, const char *why);

// Checks whether an output can be written. Standard output can if it was not closed at the start and is no
// terminal; a path always passes.
int checkOutput(const char *to, bool stdoutClosed);

// Writes a whole file, or to standard output.
int writeOutput(const char *to, const void *data, size_t size);

} // namespace odraz
