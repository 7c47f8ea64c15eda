// Showing the film as it is traced, on the clock.
#pragma once

#include "intro.h"
#include "options.h"

namespace odraz {

// Plays until the film ends or *leave is set (by the window's thread, or the viewer); exit status.
int play(Intro &intro, const Options &options, int *leave);

} // namespace odraz
