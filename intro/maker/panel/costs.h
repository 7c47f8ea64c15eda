// The costs of a picture: time by part, samples, and a map of the samples.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/inspector.h"

#include <vector>

namespace odraz::maker {

struct Costs {
    double milliseconds[(int)Cost::Count] = {};
    double whole = 0; // from the call to its return: more than the sum of the parts
    int64_t samples = 0;
    int pixels = 1;

    double samplesAPixel() const { return (double)samples / pixels; }
};

// Draws them as lines of text, and a bar divided into the parts. Returns the rectangle that it covers.
Rect drawCosts(Canvas &canvas, int x, int y, const Costs &costs);

// The colour for a number of samples a pixel: dark blue for 1/16 and less, then with every doubling through
// violet, red and orange to white at 16 and more.
Colour heatOf(float samples);

// Draws the map of samples over the picture, whose brightness shows through. Where a pixel has less than two
// samples it shows the mean of a square of up to 8 pixels a side.
void drawHeat(Canvas &canvas, const std::vector<uint32_t> &samples);
// ... and a scale of its colours. Returns the rectangle that it covers.
Rect drawHeatLegend(Canvas &canvas, int x, int y);

} // namespace odraz::maker
