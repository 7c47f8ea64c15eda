// The sound's level, each side a bar that falls slowly, with the last peak held above it.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/envelope.h"

namespace odraz::maker {

class Meter {
public:
    static constexpr float kFloor = -60; // decibels: the lower end
    static constexpr float kFall = 24;   // decibels a second
    static constexpr double kHold = 1.5; // seconds that a peak stays

    // Takes what was heard in the last `passed` seconds.
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
