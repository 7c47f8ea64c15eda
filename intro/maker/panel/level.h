// The level of the film's sound: along the whole film, and now.
#pragma once

#include "maker/panel/canvas.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace odraz::maker {

// The greatest amplitude of each side, 0 .. 1.
struct Level {
    float left = 0, right = 0;

    void raise(Level to) { left = std::max(left, to.left), right = std::max(right, to.right); }
};

// The level along the film. It is rendered once, on a thread of its own, from a copy of the music.
class Envelope {
public:
    Envelope() = default;
    Envelope(const Envelope &) = delete;
    ~Envelope() { stop(); }

    // Begins to render a film of `seconds`, and drops what was rendered before.
    void start(const Inspector &inspector, double seconds);
    // Ends that. Must be called before the film's code is replaced.
    void stop();
    bool started() const { return thread.joinable(); }

    // The second up to which it is known: it grows from 0 to the film's end within some seconds.
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

// The current level: a bar for each side that falls slowly, with the last peak held above it.
class Meter {
public:
    static constexpr float kFloor = -60; // decibels: the lower end
    static constexpr float kFall = 24;   // decibels a second
    static constexpr double kHold = 1.5; // seconds that a peak stays

    // Takes the level of the last `passed` seconds.
    void hear(Level level, double passed);
    // Decibels below full scale of a side (0 left, 1 right): what the bar shows, and the peak. kFloor at
    // least.
    float shown(int side) const { return bars[side]; }
    float peak(int side) const { return peaks[side]; }
    bool clipped(int side) const { return peaks[side] >= 0; }

private:
    float bars[2] = {kFloor, kFloor}, peaks[2] = {kFloor, kFloor};
    double age[2] = {};
};

float decibels(float amplitude); // kFloor at least

void drawMeter(Canvas &canvas, Rect where, const Meter &meter);

} // namespace odraz::maker
