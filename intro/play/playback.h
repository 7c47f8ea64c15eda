// Plays the film's sound ahead of the film's clock, and corrects the clock by what is heard.
//
// A step writes at most one block of 5 ms. Sound that would be heard too late is left out, so that the film
// never waits. When the film's time leaps, the sound leaps too. It fades out before each leap and in after
// it, in 10 ms. A lost device is tried again every second.
#pragma once

#include "host/sound.h"
#include "intro.h"
#include "play/film_clock.h"

namespace odraz {

// The source of the sound.
struct SoundSource {
    void (*seek)(void *context, int64_t frame); // makes the next block begin with this frame of the film
    void (*render)(void *context, int16_t samples[2 * kSoundBlock]); // writes the next block, and advances
    void *context;
};

class Playback {
public:
    // Must be called first, on zeroed memory. The source must be at the film's beginning.
    void prepare(const SoundSource &source, const SoundOutput &output, FilmClock &clock, double from);

    // Must be called in a loop, on a separate thread; `now` is in nanoseconds(). Returns the nanoseconds to
    // sleep before the next call.
    int64_t step(int64_t now);

    // These may be called on any thread. The sound fades out when paused or muted. silence() is true once
    // nothing is heard any more.
    void mute(bool on) { __atomic_store_n(&muted, on, __ATOMIC_RELAXED); }
    void pause(bool on) { __atomic_store_n(&paused, on, __ATOMIC_RELEASE); }
    bool silence() const { return !__atomic_load_n(&audible, __ATOMIC_ACQUIRE); }

private:
    void fill(float to);
    void leap(int64_t frame, bool still);
    void follow(int64_t now, bool full);
    int64_t lose(int64_t now);

    SoundSource source;
    SoundOutput output;
    FilmClock *clock;
    int64_t begin;              // frame from which the film is played
    int64_t position;           // first frame of the next block
    int64_t held;               // frames that the device had not yet played at the last step
    int64_t quiet;              // frames of silence written since the last sound
    int64_t openAt, lastStep;   // moments, in nanoseconds
    unsigned watched;           // clock->watched() at the last gap
    int left;                   // frames of the block that are not written yet
    float level;                // loudness at the end of the last block, 0 .. 1
    bool opened, sought, doubt; // doubt: the clock's time may be wrong
    bool paused, muted, audible;
    int16_t block[2 * kSoundBlock];
};

} // namespace odraz
