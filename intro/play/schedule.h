// The player's decisions, without threads and clock: which pictures are made, in which order, and when each
// is shown. The film, its tests and tools/measure/play all use them.
#pragma once

#include "play/governor.h"

namespace odraz {

// A finished picture, on its way to the thread that shows it.
struct FinishedPicture {
    Picture picture;
    double time;       // its time in the film, in seconds
    float trace, make; // seconds to trace it, or to make it from two others; one of them is 0
    float samples;     // samples per traced pixel
    TracedSize size;
    float level; // Governor::level() of its quality, for tools
};

// Finished pictures in the order of their times. One thread adds to the queue, another one removes from it.
// All members are zero at the start.
struct Queue {
    unsigned made, shown; // number of pictures added and removed since the start
    static constexpr unsigned kRing = 16;
    // Pictures not shown yet: at most all slots and buffers of intro.h, or the pictures of page_player.h
    FinishedPicture ring[kRing];
    static_assert(kSlots + kBetweenBuffers <= kRing);

    // The film begins when this many are ready.
    static constexpr unsigned kAhead = 3;

    unsigned ready() const { return __atomic_load_n(&made, __ATOMIC_ACQUIRE); }
    const FinishedPicture &first() const { return ring[shown % kRing]; }
    // Returns the number of pictures added since the start.
    unsigned add(const FinishedPicture &m) {
        ring[made % kRing] = m;
        __atomic_store_n(&made, made + 1, __ATOMIC_RELEASE);
        return made;
    }
    // Inserts a picture by its time; several workers may finish theirs in any order. Call it on the thread
    // that removes. The picture is dropped if a later picture has been shown.
    void insert(const FinishedPicture &m) {
        if (shown && ring[(shown - 1) % kRing].time > m.time) return;
        unsigned i = made++;
        for (; i != shown && ring[(i - 1) % kRing].time > m.time; --i)
            ring[i % kRing] = ring[(i - 1) % kRing];
        ring[i % kRing] = m;
    }
    // Decides what to do with the first picture when the film is at `time`. If several are due, all but the
    // last one are skipped.
    enum Action { kWait, kSkip, kShow };
    Action action(double time) const {
        unsigned waiting = ready() - shown;
        if (!waiting || first().time > time) return kWait;
        return waiting < 2 || ring[(shown + 1) % kRing].time > time ? kShow : kSkip;
    }
    // Removes the first picture: its slot or buffer is free.
    void remove() { __atomic_store_n(&shown, shown + 1, __ATOMIC_RELEASE); }
    // Whether at least `number` pictures have been removed.
    bool removed(unsigned number) const {
        return (int)(__atomic_load_n(&shown, __ATOMIC_ACQUIRE) - number) >= 0;
    }
};

// Prepares the governor for the scene of a picture to trace. `film` is a player as described below.
template <class Film, class G> void enter(const Film &film, G &governor, double time) {
    int scene = film.sceneOf(time);
    governor.enter(scene, film.paceOf(scene));
}
// Returns the time of the next picture to trace, after the one of `last`, when the film is at `now`.
template <class Film, class G>
double nextTime(const Film &film, const G &governor, double last, double now, int workers = 1) {
    double time = governor.next(last, now, workers);
    // Trace the first picture of a shot: otherwise in-betweens next to the cut would be made from one picture
    // only, or the cut would be shown late. A gap of two sixtieths cannot be shortened
    double start = film.startOf(time) - 1e-3;
    if (G::kMakesBetweens && start > last && governor.cadence >= G::kFours)
        for (time = last; time < start;) time += G::kSixtieth;
    return time;
}

// Makes the film's pictures from `time` on, in seconds, ahead of the film's clock. The film is scripted, so
// its pictures are known in advance. The player provides:
//
//   bool goesOn(time)               whether the picture of this time is to be made
//   int64_t now()                   the moment, in nanoseconds
//   double filmAt(now)              the film's time at that moment, in seconds, or Governor::kNotBegun
//   int sceneOf(time); Pace paceOf(scene)
//   double startOf(time)            the time at which the shot of this time begins
//   trace(picture, slot, governor)  traces the picture of picture.time in slot 0 or 1, with the governor's
//                                   quality and size
//   between(picture, earlier, later, share, buffer)
//                                   makes the picture of picture.time, `share` of the way between the
//                                   pictures of two slots
//   unsigned add(picture)           Queue::add()
//   await(number)                   waits until this many pictures have been removed from the queue
template <class Player, class G> void makePictures(Player &player, G &governor, double time) {
    // A slot, or a buffer of in-betweens, is free once this many pictures have been removed from the queue
    unsigned freeAt[2] = {}, bufferFreeAt[kBetweenBuffers] = {};
    int buffer = 0;
    double last = time;
    for (int n = 0; player.goesOn(time); ++n) {
        int slot = n & 1;
        player.await(freeAt[slot]);
        int64_t began = player.now();
        FinishedPicture m = {};
        m.time = time;
        enter(player, governor, time);
        player.trace(m, slot, governor);
        m.trace = (float)(player.now() - began) * 1e-9f;
        int gap = (int)((time - last) / G::kSixtieth + 0.5), count = n ? governor.between(gap) : 0;
        float make = 0;
        for (int i = 1; i <= count; ++i) {
            player.await(bufferFreeAt[buffer]);
            int64_t makingBegan = player.now();
            double share = 1 - (double)((count + 1 - i) * governor.spacing()) / gap;
            FinishedPicture b = {};
            b.time = last + (time - last) * share;
            player.between(b, !slot, slot, share, buffer);
            b.make = (float)(player.now() - makingBegan) * 1e-9f;
            make += b.make;
            bufferFreeAt[buffer] = player.add(b);
            buffer = (buffer + 1) % kBetweenBuffers;
        }
        freeAt[slot] = player.add(m);
        if (n) governor.spent(m.trace, make / (float)max(count, 1), count);
        last = time;
        time = nextTime(player, governor, last, player.filmAt(player.now()));
    }
}

} // namespace odraz
