// Writing the film's frames instead of showing them.
#pragma once

#include "intro.h"
#include "options.h"

namespace odraz {

// Complains that `what` cannot be written, and why; returns 1, the exit status of a failure.
int cannotWrite(const char *what, const char *why);

// Writes the frames that the options name; exit status. `stdoutClosed`: standard output was closed at the
// start.
int dump(Intro &intro, const Options &options, bool stdoutClosed);

} // namespace odraz
