// How loud the film's sound is, all along it: rendered once, on a thread of its own, from a copy of the
// music.
#pragma once

#include "maker/panel/inspector.h"

#include <atomic>
#include <thread>
#include <vector>

namespace odraz::maker {

// The greatest amplitude of each side, 0 .. 1.
struct Level {
    float left = 0, right = 0;
};

class Envelope {
public:
    Envelope() = default;
    Envelope(const Envelope &) = delete;
    ~Envelope() { stop(); }

    // Begins to render a film of so many seconds; what was known before is forgotten.
    void start(const Inspector &inspector, double seconds);
    // Ends that. Must be called before the film's code goes away.
    void stop();
    bool started() const { return thread.joinable(); }

    // Up to which second it is known: it grows from 0 to the film's end within some seconds.
    double known() const { return done.load(std::memory_order_acquire) * kBlock; }
    // The level in [from, to), as far as it is known; of at least one block of 5 ms.
    Level most(double from, double to) const;

private:
    static constexpr double kBlock = (double)kSoundBlock / kSoundRate;
    void render(const Inspector &inspector);

    std::vector<Level> blocks;
    std::atomic<int> done = 0;
    std::atomic<bool> leave = false;
    std::thread thread;
};

} // namespace odraz::maker
