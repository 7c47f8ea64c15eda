// What a picture costs: time by part, samples, and where in the picture the samples are.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/inspector.h"

#include <vector>

namespace odraz::maker {

const char *nameOf(Cost part);

struct Costs {
    double milliseconds[(int)Cost::Count] = {};
    double whole = 0; // of the picture, from the call to its return: more than the sum of the parts
    int64_t samples = 0;
    int pixels = 1;

    double samplesAPixel() const { return (double)samples / pixels; }
};

// Draws them as lines of text, and a bar whose stretches are the parts; returns the rectangle that it took.
Rect drawCosts(Canvas &canvas, int x, int y, const Costs &costs);

// The colour of so many samples in a pixel: dark blue for less than one in sixteen, then by every doubling
// through violet, red and orange to white at 16 and more.
Colour heatOf(float samples);

// Lays the map of samples over the picture, whose brightness shows through. Where there is less
// than two samples in a pixel it shows the mean of a square of up to 8 pixels a side.
void drawHeat(Canvas &canvas, const std::vector<uint32_t> &samples);
// ... and what the colours mean. Returns the rectangle that it took.
Rect drawHeatLegend(Canvas &canvas, int x, int y);

} // namespace odraz::maker
