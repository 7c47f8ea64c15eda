// The film's music, played on a separate thread, and the clock that film and music share.
#pragma once

#include "play/playback.h"

namespace odraz {

struct Music {
    FilmClock clock;
    Playback playback;
    Sound *sound; // null: silence
    int block;    // the next block of it
};

// Starts the music at a time of the film, in seconds; `music` is zeroed, and must outlive the program's
// threads. Returns when the device is ready, after a third of a second at the latest, or when *leave is set;
// the film's clock runs from then on. Without a device, a thread or `sound` (which may be null) there is
// silence, and no message.
void startMusic(Music &music, Sound *sound, double from, const int *leave);

// Fades it out and returns when nothing is heard any more, after 100 ms at the latest.
void endMusic(Music &music);

} // namespace odraz
