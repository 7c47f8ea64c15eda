// The film's music, played on a separate thread, and the clock that film and music share.
#pragma once

#include "play/playback.h"

namespace odraz {

struct Music {
    FilmClock clock;
    Playback playback;
    Sound *sound; // null: silence
    int block;    // number of its next block
};

// Starts the music at a time of the film, in seconds. `music` must be zeroed and outlive all threads. Returns
// when the device is ready, when *leave is set, or after a third of a second; the film's clock runs from then
// on. Without a device, a thread or a sound (`sound` is null) there is silence, and no message.
void startMusic(Music &music, Sound *sound, double from, const int *leave);

// Fades the music out. Returns once nothing is heard any more, after 100 ms at the latest.
void endMusic(Music &music);

} // namespace odraz
