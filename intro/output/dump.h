// Writes the film's frames instead of showing them.
#pragma once

#include "intro.h"
#include "options.h"

namespace odraz {

// Writes the frames that the options select. Returns an exit status. `stdoutClosed`: standard output was
// closed at the start.
int dump(Intro &intro, const Options &options, bool stdoutClosed);

} // namespace odraz
