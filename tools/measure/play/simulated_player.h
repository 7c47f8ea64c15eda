// Simulated players, whose clocks advance only by the time that work is assumed to take: SimulatedPlayer runs
// makePictures() and shows each picture at its time, as play() does; playPage() runs a PagePlayer.
#pragma once

#include "play/page_player.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace odraz::measure {

inline int64_t nanosecondsOf(double seconds) { return std::llround(seconds * 1e9); }

class SimulatedPlayer {
public:
    // `from`: the second of the film at which it begins.
    explicit SimulatedPlayer(double from) : from(from) {}
    virtual ~SimulatedPlayer() = default;

    // Part of the interface that makePictures() needs
    int64_t now() const { return moment; }
    double filmAt(int64_t at) const {
        return begin < 0 ? Governor::kNotBegun : from + (double)(at - begin) * 1e-9;
    }
    unsigned add(const FinishedPicture &made) {
        showUntil(moment);
        unsigned count = queue.add(made);
        if (count == Queue::kAhead) begin = moment;
        return count;
    }
    void await(unsigned number) {
        while (!queue.removed(number)) {
            if (begin < 0 || queue.shown == queue.made) throw std::logic_error("the player waits forever");
            moment = std::max(moment, nextDue());
            showUntil(moment);
        }
    }

protected:
    // Shows the picture with this number in the queue. May advance `looked` by the time that this takes.
    virtual void show(unsigned) {}

    void showUntil(int64_t until) {
        while (begin >= 0 && queue.shown < queue.made && nextDue() <= until) {
            looked = nextDue();
            Queue::Action action = queue.action(filmAt(looked));
            if (action == Queue::kWait) ++looked; // the due time was rounded down
            if (action == Queue::kShow) show(queue.shown);
            if (action != Queue::kWait) queue.remove();
        }
        looked = std::max(looked, until);
    }

    double from;
    Queue queue = {};
    int64_t moment = 0; // now, ns
    int64_t begin = -1; // the time of the film's first picture, ns; -1 before it
    int64_t looked = 0; // pictures were shown until this time, ns

private:
    // The time at which the first waiting picture is due, ns.
    int64_t nextDue() const { return std::max(looked, begin + nanosecondsOf(queue.first().time - from)); }
};

// Plays as the page does, from the second `from` of the film on. The screen is refreshed every `refresh`
// seconds, the first time after half of that, and shows pictures up to `nearest` seconds early. The player's
// film also provides
//
//   int64_t tracing(made)     returns the nanoseconds that a worker takes for a picture
//   int64_t show(made, at)    shows a picture at this time of the film; returns the ns that all workers lose
template <class Film> void playPage(PagePlayer<Film> &player, double from, double refresh, double nearest) {
    struct Busy {
        FinishedPicture made;
        int64_t begun, end;
    };
    std::vector<Busy> busy;
    int64_t moment = 0, begin = -1;
    for (int64_t refreshes = 0;;) {
        auto filmAt = [&] {
            return begin < 0 ? Governor::kNotBegun : from + (double)(moment - begin) * 1e-9;
        };
        if (begin < 0 && player.ready() == 1) begin = moment;
        while ((int)busy.size() < player.workers && player.next(filmAt())) {
            FinishedPicture m = {};
            m.time = player.time, m.size = player.governor.size(), m.level = player.governor.level();
            busy.push_back({m, moment, moment + player.film->tracing(m)});
        }
        if (busy.empty() && begin < 0)
            begin = moment; // the whole film has fewer pictures than are made before the start
        if (busy.empty() && !player.waiting()) return;
        auto first = std::min_element(busy.begin(), busy.end(),
                                      [](const Busy &a, const Busy &b) { return a.end < b.end; });
        double at = ((double)refreshes + 0.5) * refresh;
        int64_t next = begin + nanosecondsOf(at);
        if (begin >= 0 && (first == busy.end() || next < first->end)) {
            moment = next, ++refreshes;
            if (const FinishedPicture *due = player.due(from + at, nearest)) {
                for (int64_t lost = player.film->show(*due, from + at); Busy & b : busy) b.end += lost;
                player.queue->remove();
            }
        } else {
            moment = first->end;
            FinishedPicture m = first->made;
            m.trace = (float)(moment - first->begun) * 1e-9f;
            busy.erase(first);
            player.traced(m);
        }
    }
}

} // namespace odraz::measure
