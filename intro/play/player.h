// Shows the film while it is being traced, by the clock.
#pragma once

#include "host/window.h"
#include "intro.h"
#include "options.h"
#include "play/schedule.h"

namespace odraz {

// For tools: is called with each picture and the time of the film, in seconds, at which it came on the
// screen, or -1 if it was skipped. The film has none.
struct Recorder {
    void (*record)(void *context, const Made &made, double at);
    void *context;
};

// Plays until the film ends or *leave is set (by the window's thread, for the viewer); exit status. `sound`
// is null for silence; `began` is when the program started, in nanoseconds().
int play(Intro &intro, Sound *sound, const Options &options, FilmWindow &window, const int *leave,
         int64_t began, const Recorder *recorder = nullptr);

} // namespace odraz
