#include "play/film_clock.h"

namespace odraz {

void FilmClock::start(double time, int64_t now) {
    __atomic_store_n(&zero, now - (int64_t)(time * 1e9), __ATOMIC_RELAXED);
    lastCorrected = now;
    __atomic_store_n(&running, true, __ATOMIC_RELEASE);
}

void FilmClock::correct(double time, int64_t now) {
    double error = time - at(now);
    // Correct by at most a hundredth of the elapsed time, so that the clock never stops, however often this
    // is called
    double limit = (double)(now - lastCorrected) * 1e-11;
    lastCorrected = now;
    double milliseconds = (error < 0 ? -error : error) * 1e3;
    ++errors[milliseconds < kErrors - 1 ? (int)milliseconds : kErrors - 1];
    if (!(error >= -kMostError && error <= kMostError)) return;
    if (limit > 5e-5) limit = 5e-5;
    error = error < -limit ? -limit : error > limit ? limit : error;
    __atomic_sub_fetch(&zero, (int64_t)(error * 1e9), __ATOMIC_RELAXED);
}

void FilmClock::watch(int64_t now, int64_t processor) {
    int64_t passed = now - lastWatch;
    if (lastWatch && passed > kGap && processor - lastProcessor < passed / 16)
        __atomic_add_fetch(&zero, passed, __ATOMIC_RELAXED);
    lastWatch = now;
    lastProcessor = processor;
    __atomic_add_fetch(&watches, 1, __ATOMIC_RELEASE);
}

} // namespace odraz
