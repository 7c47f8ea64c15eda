// Writing the film's frames instead of showing them.
#pragma once

#include "intro.h"
#include "options.h"

namespace odraz {

// Complains that `what` cannot be written, and why; returns 1, the exit status of a failure.
int cannotWrite(const char *what, const char *why);

// Whether an output, a path or "-", can be written at all: standard output neither closed at the start nor a
// terminal. Complains otherwise; exit status.
int checkOutput(const char *to, bool stdoutClosed);

// Writes a whole file, or to standard output where `to` is "-"; exit status.
int writeOutput(const char *to, const void *data, size_t size);

// Writes the frames that the options name; exit status. `stdoutClosed`: standard output was closed at the
// start.
int dump(Intro &intro, const Options &options, bool stdoutClosed);

} // namespace odraz
