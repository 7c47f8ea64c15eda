// Plays the film's sound ahead of its clock, and sets the clock by what is heard.
//
// A step writes at most one block of 5 ms. Sound that would be heard too late is left out, so that the film
// never waits; when the film's time leaps, the sound follows to that place. Every leap lies between a fade
// out and a fade in of 10 ms. A device that is lost is opened again every second.
#pragma once

#include "host/sound.h"
#include "intro.h"
#include "play/film_clock.h"

namespace odraz {

// What is played, from some time of the film on.
struct SoundSource {
    void (*seek)(void *context, int64_t frame); // the next block begins with this frame of the film
    void (*render)(void *context, int16_t samples[2 * kSoundBlock]); // ... and moves on
    void *context;
};

class Playback {
public:
    // Called first, on zeroed memory. The source stands at the film's beginning.
    void prepare(const SoundSource &source, const SoundOutput &output, FilmClock &clock, double from);

    // Must be called again and again, on a separate thread; `now` is in nanoseconds(). Returns how long to
    // sleep, in nanoseconds.
    int64_t step(int64_t now);

    // These may be called on any thread. Paused, it fades out; silence() is true once nothing is heard any
    // more.
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
    int64_t begin;              // frame that the film is played from
    int64_t position;           // frame that the next block begins with
    int64_t held;               // frames that the device had not yet played at the last step
    int64_t quiet;              // frames of silence written since the last sound
    int64_t openAt, lastStep;   // moments
    unsigned watched;           // of the clock, when it was last in doubt
    int left;                   // frames of the block that are not written yet
    float level;                // of the last block's end, 0 .. 1
    bool opened, sought, doubt; // doubt: the clock's time may be wrong
    bool paused, audible;
    int16_t block[2 * kSoundBlock];
};

} // namespace odraz
