// Plays the film: one thread traces it ahead of its clock, another one shows it.
#pragma once

#include "host/window.h"
#include "intro.h"
#include "options.h"
#include "play/schedule.h"

namespace odraz {

// A callback for tools, which the film does not use. It gets each picture and the time of the film, in
// seconds, at which it was shown; -1 if it was skipped.
struct Recorder {
    void (*record)(void *context, const FinishedPicture &made, double at);
    void *context;
};

// Plays until the film ends or the window's thread sets *leave. Returns an exit status. `sound`: null for
// silence. `began`: the moment of the program's start, in nanoseconds(). May be called once in a process.
int play(Intro &intro, Sound *sound, const Options &options, FilmWindow &window, const int *leave,
         int64_t began, const Recorder *recorder = nullptr);

} // namespace odraz
