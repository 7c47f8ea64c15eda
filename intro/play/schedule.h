// Which pictures of the film are made, in which order, and which of them is shown when: the player's
// decisions, without its threads and its clock. So the film, tests and tools/measure/seen play alike.
#pragma once

#include "play/governor.h"

namespace odraz {

// A picture on its way from who makes it to who shows it.
struct Made {
    Picture picture;
    double time;       // of the film, in seconds
    float trace, make; // seconds that tracing it took, or making it between two others; the other one is 0
    float samples;     // per traced pixel
    TracedSize size;
    float level; // of the quality that it was traced at, for tools alone
};

// Made pictures in the order in which they are shown. One thread adds to it and another one shows. Zero at
// the start.
struct Queue {
    unsigned made, shown; // numbers of pictures, since the start
    static constexpr unsigned kRing = 8;
    Made ring[kRing]; // those not shown yet; makePictures() never has more than its slots and places
    static_assert(kSlots + kPlaces <= kRing);

    // The film begins when this many are ready.
    static constexpr unsigned kAhead = 3;

    unsigned ready() const { return __atomic_load_n(&made, __ATOMIC_ACQUIRE); }
    const Made &first() const { return ring[shown % kRing]; }
    // Returns how many were made.
    unsigned add(const Made &m) {
        ring[made % kRing] = m;
        __atomic_store_n(&made, made + 1, __ATOMIC_RELEASE);
        return made;
    }
    // What happens to the first one when the film is at `time`: if the time of several has come, only the
    // last of them is shown.
    enum Turn { kWaits, kPasses, kShows };
    Turn turn(double time) const {
        unsigned waiting = ready() - shown;
        if (!waiting || first().time > time) return kWaits;
        return waiting < 2 || ring[(shown + 1) % kRing].time > time ? kShows : kPasses;
    }
    // The first one was shown, or passed over: its place may be used again.
    void pass() { __atomic_store_n(&shown, shown + 1, __ATOMIC_RELEASE); }
    bool passed(unsigned number) const {
        return (int)(__atomic_load_n(&shown, __ATOMIC_ACQUIRE) - number) >= 0;
    }
};

// Makes the film from `time` on, in seconds, ahead of its clock, which is possible because it is scripted.
// The stage is where that happens:
//
//   bool wants(time)                whether the film goes on, with the picture of this time
//   int64_t now()                   nanoseconds of its clock
//   double filmAt(now)              the film's time at that moment; Governor::kNotBegun
//   int sceneOf(time); Pace paceOf(scene)
//   trace(made, slot, governor)     traces the picture of made.time in slot 0 or 1, with the governor's
//                                   quality and size
//   between(made, earlier, later, share, place)
//                                   makes the one of made.time, `share` of the way between those of two slots
//   unsigned add(made)              adds to the queue, and returns how many were added
//   await(number)                   waits until that many have been shown
template <class Stage> void makePictures(Stage &stage, Governor &governor, double time) {
    // How many pictures must have been shown before each slot, and each place of in-betweens, may be used
    // again
    unsigned until[2] = {}, untilBetween[kPlaces] = {};
    int place = 0;
    double last = time;
    for (int n = 0; stage.wants(time); ++n) {
        int slot = n & 1;
        stage.await(until[slot]);
        int64_t began = stage.now();
        Made m = {};
        m.time = time;
        int scene = stage.sceneOf(time);
        governor.enter(scene, stage.paceOf(scene));
        stage.trace(m, slot, governor);
        m.trace = (float)(stage.now() - began) * 1e-9f;
        int gap = (int)((time - last) / Governor::kSixtieth + 0.5), count = n ? governor.between(gap) : 0;
        float make = 0;
        for (int i = 1; i <= count; ++i) {
            stage.await(untilBetween[place]);
            int64_t waited = stage.now();
            double share = 1 - (double)governor.ahead(i) / gap;
            Made b = {};
            b.time = last + (time - last) * share;
            stage.between(b, !slot, slot, share, place);
            b.make = (float)(stage.now() - waited) * 1e-9f;
            make += b.make;
            untilBetween[place] = stage.add(b);
            place = (place + 1) % kPlaces;
        }
        until[slot] = stage.add(m);
        if (n) governor.spent(m.trace, make / (float)max(count, 1), count);
        last = time;
        time = governor.next(time, stage.filmAt(stage.now()));
    }
}

} // namespace odraz
