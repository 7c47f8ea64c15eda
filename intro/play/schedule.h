// Which pictures are made, in which order, and when each is shown: the player's decisions, without its
// threads and its clock. The film, its tests and tools/measure/seen all play by them.
#pragma once

#include "play/governor.h"

namespace odraz {

// A finished picture, on its way to the thread that shows it.
struct Made {
    Picture picture;
    double time;       // of the film, in seconds
    float trace, make; // seconds that it took to trace, or to make between two others; the other one is 0
    float samples;     // per traced pixel
    TracedSize size;
    float level; // of its quality (Governor::level), for tools alone
};

// Made pictures in the order of their times. One thread adds to it, another one shows. Zero at the start.
struct Queue {
    unsigned made, shown; // since the start
    static constexpr unsigned kRing = 16;
    Made ring[kRing]; // those not shown yet: at most all slots and places of intro.h, or page_player.h's
    static_assert(kSlots + kPlaces <= kRing);

    // The film begins when this many are ready.
    static constexpr unsigned kAhead = 3;

    unsigned ready() const { return __atomic_load_n(&made, __ATOMIC_ACQUIRE); }
    const Made &first() const { return ring[shown % kRing]; }
    // Returns the number of pictures added since the start.
    unsigned add(const Made &m) {
        ring[made % kRing] = m;
        __atomic_store_n(&made, made + 1, __ATOMIC_RELEASE);
        return made;
    }
    // Adds one of several workers', on the thread that shows: before those that are later, or not at all if a
    // later one has been shown.
    void insert(const Made &m) {
        if (shown && ring[(shown - 1) % kRing].time > m.time) return;
        unsigned i = made++;
        for (; i != shown && ring[(i - 1) % kRing].time > m.time; --i)
            ring[i % kRing] = ring[(i - 1) % kRing];
        ring[i % kRing] = m;
    }
    // What to do with the first picture when the film is at `time`. If several are due, all but the last are
    // skipped.
    enum Action { kWait, kSkip, kShow };
    Action action(double time) const {
        unsigned waiting = ready() - shown;
        if (!waiting || first().time > time) return kWait;
        return waiting < 2 || ring[(shown + 1) % kRing].time > time ? kShow : kSkip;
    }
    // Removes the first picture: its slot or place is free.
    void remove() { __atomic_store_n(&shown, shown + 1, __ATOMIC_RELEASE); }
    // Whether that many pictures have been removed.
    bool removed(unsigned number) const {
        return (int)(__atomic_load_n(&shown, __ATOMIC_ACQUIRE) - number) >= 0;
    }
};

// The scene and the moment of a picture to trace; `film` is a player as below.
template <class Film, class G> void enter(const Film &film, G &governor, double time) {
    int scene = film.sceneOf(time);
    governor.enter(scene, film.paceOf(scene));
}
// ... the moment of the next one, behind that of `last`, if the film is at `now`.
template <class Film, class G>
double nextTime(const Film &film, const G &governor, double last, double now, int workers = 1) {
    double time = governor.next(last, now, workers);
    // A shot's first picture is traced: in-betweens beside a cut are made from one picture alone, or a
    // cut would wait for the next picture. A gap of two sixtieths is too short to be cut shorter
    double start = film.startOf(time) - 1e-3;
    if (G::kMakesBetweens && start > last && governor.cadence >= G::kFours)
        for (time = last; time < start;) time += G::kSixtieth;
    return time;
}

// Makes the film from `time` on, in seconds, ahead of its clock, which is possible because it is scripted.
// The player provides:
//
//   bool goesOn(time)               whether the film goes on, with the picture of this time
//   int64_t now()                   nanoseconds of its clock
//   double filmAt(now)              the film's time at that moment, in seconds; Governor::kNotBegun
//   int sceneOf(time); Pace paceOf(scene)
//   double startOf(time)            when the shot that is shown then begins
//   trace(made, slot, governor)     traces the picture of made.time in slot 0 or 1, with the governor's
//                                   quality and size
//   between(made, earlier, later, share, place)
//                                   makes the picture of made.time, `share` of the way between those of two
//                                   slots
//   unsigned add(made)              Queue::add()
//   await(number)                   waits until that many pictures have been removed from the queue
template <class Player, class G> void makePictures(Player &player, G &governor, double time) {
    // A slot, or a place of in-betweens, is free once this many pictures have been removed
    unsigned freeAt[2] = {}, placeFreeAt[kPlaces] = {};
    int place = 0;
    double last = time;
    for (int n = 0; player.goesOn(time); ++n) {
        int slot = n & 1;
        player.await(freeAt[slot]);
        int64_t began = player.now();
        Made m = {};
        m.time = time;
        enter(player, governor, time);
        player.trace(m, slot, governor);
        m.trace = (float)(player.now() - began) * 1e-9f;
        int gap = (int)((time - last) / G::kSixtieth + 0.5), count = n ? governor.between(gap) : 0;
        float make = 0;
        for (int i = 1; i <= count; ++i) {
            player.await(placeFreeAt[place]);
            int64_t begun = player.now();
            double share = 1 - (double)((count + 1 - i) * governor.apart()) / gap;
            Made b = {};
            b.time = last + (time - last) * share;
            player.between(b, !slot, slot, share, place);
            b.make = (float)(player.now() - begun) * 1e-9f;
            make += b.make;
            placeFreeAt[place] = player.add(b);
            place = (place + 1) % kPlaces;
        }
        freeAt[slot] = player.add(m);
        if (n) governor.spent(m.trace, make / (float)max(count, 1), count);
        last = time;
        time = nextTime(player, governor, last, player.filmAt(player.now()));
    }
}

} // namespace odraz
