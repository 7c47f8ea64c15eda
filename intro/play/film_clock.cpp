#include "play/film_clock.h"

namespace odraz {

void FilmClock::start(double time, int64_t now) {
    __atomic_store_n(&zero, now - (int64_t)(time * 1e9), __ATOMIC_RELAXED);
    lastCorrected = now;
    __atomic_store_n(&running, true, __ATOMIC_RELEASE);
}

void FilmClock::correct(double time, int64_t now) {
    double off = time - at(now);
    // Correct it by at most a hundredth of the time that passed: so it never stands still, however often
    // this is called
    double most = (double)(now - lastCorrected) * 1e-11;
    lastCorrected = now;
    double far = (off < 0 ? -off : off) * 1e3;
    ++offsets[far < kOffsets - 1 ? (int)far : kOffsets - 1];
    if (!(off >= -kMostOff && off <= kMostOff)) return;
    if (most > 5e-5) most = 5e-5;
    off = off < -most ? -most : off > most ? most : off;
    __atomic_sub_fetch(&zero, (int64_t)(off * 1e9), __ATOMIC_RELAXED);
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
