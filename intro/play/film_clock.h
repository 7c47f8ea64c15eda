// The time of the film as it is played. It runs with the system's clock, and is corrected by the position
// that the sound device reports, by at most 1 % of the time that passes, which is not seen. It never goes
// back.
#pragma once

#include <stdint.h>

namespace odraz {

class FilmClock {
public:
    // The film's time, in seconds, at a moment (nanoseconds of the system's clock); unset until started.
    double at(int64_t now) const { return (double)(now - __atomic_load_n(&zero, __ATOMIC_RELAXED)) * 1e-9; }
    bool started() const { return __atomic_load_n(&running, __ATOMIC_ACQUIRE); }

    // Sets the film's time: at the start, and when the viewer seeks.
    void start(double time, int64_t now);
    // The device reports that this time of the film is heard now. A report that is more than kMostOff
    // seconds off is ignored.
    void correct(double time, int64_t now);
    // Must be called once a picture, with the processor time that the process has used. If the process was
    // stopped since the last call (much time passed, and it did almost nothing), the film goes on where it
    // stopped.
    void watch(int64_t now, int64_t processor);
    // How often watch() was called: after a gap in its own calls the sound waits for the next one.
    unsigned watched() const { return __atomic_load_n(&watches, __ATOMIC_ACQUIRE); }

    // A histogram of the clock's error against the sound: entry N counts errors of N milliseconds, the last
    // one also all larger ones.
    static constexpr int kOffsets = 250;
    int offsets[kOffsets];

    static constexpr double kMostOff = 0.25;
    static constexpr int64_t kGap =
        250000000; // nanoseconds; a longer gap may mean that the process was stopped

private:
    int64_t zero; // the moment of the film's first picture
    int64_t lastCorrected, lastWatch, lastProcessor;
    unsigned watches;
    bool running;
};

} // namespace odraz
