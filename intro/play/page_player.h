// The player's decisions where several workers trace pictures, each one on its own and for itself, as the
// page's do. The page and tools/measure/seen play by them.
#pragma once

#include "play/schedule.h"

namespace odraz {

// A scene's limits there. A browser takes twice the time of the film, and too few pictures look worse than
// too few pixels. No in-betweens are made: each takes two thirds of the time of a traced picture, and every
// worker would trace a picture of its neighbour again. So all pictures are traced, 60 a second, or 30:
// without in-betweens the governor's pairs.
inline Pace pageOf(Pace p) {
    constexpr int kLeastWidth = 480;
    p.leastWidth = min(p.leastWidth, kLeastWidth);
    p.penalty[Governor::kPairs] = p.penalty[Governor::kThirty];
    for (int c = Governor::kPairs + 1; c < kCadences; ++c) p.penalty[c] = 1e9f;
    return p;
}

// A page has one for every processor, up to that many.
inline constexpr int kMostPageWorkers = 8;
inline int pageWorkers(int cores) { return min(cores, kMostPageWorkers); }

// Whether a picture can be traced now, later, or never: for want of the hall's light.
enum class Can { Now, Later, Never };

// `Film` provides sceneOf(), startOf(), paceOf() and goesOn() as the player of makePictures() does, and `Can
// can(time)`.
template <class Film> struct PagePlayer {
    static constexpr unsigned kMostReady = 8; // pictures that stand ready, besides those being traced
    static_assert(kMostReady + kMostPageWorkers <= Queue::kRing);
    // A refresh of the screen shows pictures of up to that many seconds later: it is the one next to their
    // time
    static constexpr double kNearest = 0.008;

    Film *film;
    Queue *queue;
    int workers;
    unsigned most = 0; // pictures that are ready or being traced
    GovernorOf<false> governor = {};
    double time = 0;                 // the next picture's to trace, or the last one's
    bool planned = false;            // it is that of the next one
    unsigned started = 0, ended = 0; // pictures whose tracing has

    // Plays from there on. What was made before is forgotten, but for what the governor has learned.
    void begin(double from, int width, int height) {
        governor.width = width, governor.height = height;
        queue->made = queue->shown = started = ended = 0;
        most = kMostReady + (unsigned)workers;
        time = from, planned = true;
    }
    unsigned waiting() const { return queue->made - queue->shown; }
    // Whether an idle worker shall trace a picture, if the film is at `now`: that of `time`, with the
    // governor's level and size.
    bool next(double now) {
        for (;; planned = false) {
            if (!planned) time = nextTime(*film, governor, time, now, workers), planned = true;
            if (!film->goesOn(time) || waiting() + started - ended >= most) return false;
            Can can = film->can(time);
            if (can == Can::Later) return false;
            if (can == Can::Now) break;
        }
        enter(*film, governor, time);
        ++started, planned = false;
        return true;
    }
    // A worker has traced that picture, in m.trace seconds. Its first one does not count: it takes longer.
    void traced(const Made &m) {
        if (ended++ >= (unsigned)workers) governor.spent(m.trace / (float)workers, 0, 0);
        queue->insert(m);
    }
    // Whether enough pictures are ready to begin: 1.
    float ready() const { return min((float)waiting() / (float)min((int)most, (int)Queue::kAhead), 1.f); }
};

} // namespace odraz
