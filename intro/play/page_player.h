// The player's decisions for several workers, each of which traces whole pictures, as on the page.
#pragma once

#include "play/schedule.h"

namespace odraz {

// Returns a scene's limits for the page. A browser takes twice the time of the film, and too few pictures
// look worse than too few pixels. No in-betweens are made: one takes two thirds of the time of a traced
// picture, and needs both neighbours, which other workers hold. So all pictures are traced: 60 a second, or
// 30, which are the governor's pairs without in-betweens.
inline Pace pageOf(Pace p) {
    p.leastWidth = min(p.leastWidth, 480); // pixels
    p.penalty[Governor::kPairs] = p.penalty[Governor::kThirty];
    for (int c = Governor::kPairs + 1; c < kCadences; ++c) p.penalty[c] = 1e9f;
    return p;
}

// A page has one worker for each processor, but no more than this.
inline constexpr int kMostPageWorkers = 8;
inline int pageWorkers(int cores) { return min(cores, kMostPageWorkers); }

// When a picture can be traced. One that needs the hall's light waits for it; if the light cannot be solved,
// it is never traced.
enum class Traceable { Now, Later, Never };

// `Film` provides sceneOf(), startOf(), paceOf() and goesOn() as the player of makePictures() does, and
// `Traceable traceable(time)`.
template <class Film> struct PagePlayer {
    static constexpr unsigned kMostReady = 8; // finished pictures that wait to be shown
    static_assert(kMostReady + kMostPageWorkers <= Queue::kRing);
    // A refresh may show a picture this many seconds early, about half of 1/60 s: no other one is nearer
    static constexpr double kNearest = 0.008;

    Film *film;
    Queue *queue;
    int workers;
    unsigned most = 0; // limit on the pictures that are finished or being traced
    GovernorOf<false> governor = {};
    double time = 0;                 // time of the next picture to trace if `planned`, else of the last one
    bool planned = false;            // whether the next picture's time is decided
    unsigned started = 0, ended = 0; // number of pictures whose tracing has started, and has ended

    // Plays from `from` on. All pictures are forgotten, but not what the governor has learned.
    void begin(double from, int width, int height) {
        governor.width = width, governor.height = height;
        queue->made = queue->shown = started = ended = 0;
        most = kMostReady + (unsigned)workers, time = from, planned = true;
    }
    unsigned waiting() const { return queue->made - queue->shown; }
    // Decides, when the film is at `now`, whether an idle worker traces another picture. If so, it is the
    // picture of `time`, with the governor's level and size.
    bool next(double now) {
        for (;; planned = false) {
            if (!planned) time = nextTime(*film, governor, time, now, workers), planned = true;
            if (!film->goesOn(time) || waiting() + started - ended >= most) return false;
            Traceable when = film->traceable(time);
            if (when == Traceable::Later) return false;
            if (when == Traceable::Now) break;
        }
        enter(*film, governor, time);
        ++started, planned = false;
        return true;
    }
    // Accepts a picture, traced in m.trace seconds. The governor ignores each worker's first, slower one.
    void traced(const FinishedPicture &m) {
        if (ended++ >= (unsigned)workers) governor.spent(m.trace / (float)workers, 0, 0);
        queue->insert(m);
    }
    // Removes late pictures. Returns the one to show at a refresh of the screen at `now`; null: none.
    const FinishedPicture *due(double now, double nearest = kNearest) {
        while (queue->action(now + nearest) == Queue::kSkip) queue->remove();
        return queue->action(now + nearest) == Queue::kShow ? &queue->first() : nullptr;
    }
    // The share that is finished, 0 .. 1, of the pictures that the film needs to begin.
    float ready() const { return min((float)waiting() / (float)min((int)most, (int)Queue::kAhead), 1.f); }
};

} // namespace odraz
