// The film's clock while it is played. It runs with the system's clock, and is corrected by the position that
// the sound device reports: by at most 1 % of the elapsed time, which no viewer sees. It never goes back.
#pragma once

#include <stdint.h>

namespace odraz {

class FilmClock {
public:
    // Returns the film's time, in seconds, at a moment of the system's clock, in nanoseconds. It is undefined
    // before start().
    double at(int64_t now) const { return (double)(now - __atomic_load_n(&zero, __ATOMIC_RELAXED)) * 1e-9; }
    bool started() const { return __atomic_load_n(&running, __ATOMIC_ACQUIRE); }

    // Sets the film's time: at the start, and when the viewer seeks.
    void start(double time, int64_t now);
    // Corrects the clock: `time` is the film's time that is heard now, as the device reports it. An error of
    // more than kMostError seconds is ignored.
    void correct(double time, int64_t now);
    // Must be called once for each picture, with the processor time that the process has used. If the process
    // was stopped since the last call (much time has passed, but little of it on the processor), the film
    // continues from where it stopped.
    void watch(int64_t now, int64_t processor);
    // The number of calls of watch(). If the sound was not scheduled for a while, it waits for the next call.
    unsigned watched() const { return __atomic_load_n(&watches, __ATOMIC_ACQUIRE); }

    // A histogram of the clock's errors: entry N counts errors of N milliseconds, the last entry also all
    // larger ones.
    static constexpr int kErrors = 250;
    int errors[kErrors];

    static constexpr double kMostError = 0.25;
    // Nanoseconds between two calls; after a longer gap the process may have been stopped.
    static constexpr int64_t kGap = 250000000;

private:
    int64_t zero; // moment of the film's beginning
    int64_t lastCorrected, lastWatch, lastProcessor;
    unsigned watches;
    bool running;
};

} // namespace odraz
