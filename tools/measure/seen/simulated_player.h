// A player without a machine, for makePictures(). Its clock moves only by the time that work is assumed to
// take, and its screen shows each picture when the film is at its time, as play() does.
#pragma once

#include "play/schedule.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odraz::measure {

inline int64_t nanosecondsOf(double seconds) { return std::llround(seconds * 1e9); }

class SimulatedPlayer {
public:
    // `from`: seconds of the film at which it begins.
    explicit SimulatedPlayer(double from) : from(from) {}
    virtual ~SimulatedPlayer() = default;

    // A part of the interface that makePictures() needs
    int64_t now() const { return moment; }
    double filmAt(int64_t at) const {
        return begin < 0 ? Governor::kNotBegun : from + (double)(at - begin) * 1e-9;
    }
    unsigned add(const Made &made) {
        showUntil(moment);
        unsigned count = queue.add(made);
        if (count == Queue::kAhead) begin = moment;
        return count;
    }
    void await(unsigned number) {
        while (!queue.removed(number)) {
            if (begin < 0 || queue.shown == queue.made) throw std::logic_error("the player waits for ever");
            moment = std::max(moment, nextDue());
            showUntil(moment);
        }
    }

protected:
    // A picture comes on the screen, by its number in the queue. Showing takes time: `looked` may be moved.
    virtual void show(unsigned) {}

    void showUntil(int64_t until) {
        while (begin >= 0 && queue.shown < queue.made && nextDue() <= until) {
            looked = nextDue();
            Queue::Action action = queue.action(filmAt(looked));
            if (action == Queue::kWait) ++looked; // it was rounded down
            if (action == Queue::kShow) show(queue.shown);
            if (action != Queue::kWait) queue.remove();
        }
        looked = std::max(looked, until);
    }

    double from;
    Queue queue = {};
    // Nanoseconds: now; the film's first picture, -1 before it; until when pictures were shown
    int64_t moment = 0, begin = -1, looked = 0;

private:
    // When the first waiting picture is due.
    int64_t nextDue() const { return std::max(looked, begin + nanosecondsOf(queue.first().time - from)); }
};

} // namespace odraz::measure
