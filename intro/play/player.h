// Shows the film while it is being traced, by the clock.
#pragma once

#include "host/window.h"
#include "intro.h"
#include "options.h"
#include "play/schedule.h"

namespace odraz {

// For tools: is told of each picture when it came on the screen, in seconds of the film, or -1 if it was
// passed over. The film has none, and leaves the calls out (base/for_tools.h).
struct Recorder {
    void (*tell)(void *context, const Made &made, double at);
    void *context;
};

// Plays until the film ends or *leave is set (by the window's thread, for the viewer); exit status. `sound`
// is null for silence; `began` is when the program started, in nanoseconds().
int play(Intro &intro, Sound *sound, const Options &options, FilmWindow &window, const int *leave,
         int64_t began, const Recorder *recorder = nullptr);

} // namespace odraz
