// The film's music, played on a thread of its own, and the clock that film and music share.
#pragma once

#include "playback.h"

namespace odraz {

struct Music {
    FilmClock clock;
    Playback playback;
    Sound *sound; // null: silence
    int block;    // of it that comes next
};

// Starts it, on zeroed memory that stays, from a time of the film on; the film begins when what plays it is
// ready, and in a third of a second at the latest. Whatever is missing, it is silent and says nothing.
// `sound` may be null; *leave ends the waiting.
void startMusic(Music &music, Sound *sound, double from, const int *leave);

// Fades it out and returns when nothing is heard any more, after 100 ms at the latest.
void endMusic(Music &music);

} // namespace odraz
