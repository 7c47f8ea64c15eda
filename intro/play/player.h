// Shows the film while it is being traced, by the clock.
#pragma once

#include "host/window.h"
#include "intro.h"
#include "options.h"

namespace odraz {

// Plays until the film ends or *leave is set (by the window's thread, for the viewer); exit status. `sound`
// is null for silence; `began` is when the program started, in nanoseconds().
int play(Intro &intro, Sound *sound, const Options &options, FilmWindow &window, const int *leave,
         int64_t began);

} // namespace odraz
