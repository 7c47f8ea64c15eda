// The costs of a picture: time by part, number of samples, and a map of the samples.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/inspector.h"

#include <vector>

namespace odraz::maker {

struct PictureCosts {
    double milliseconds[(int)PicturePart::Count] = {};
    double whole = 0; // from the call to its return: more than the sum of the parts
    int64_t samples = 0;
    int pixels = 1;

    double samplesAPixel() const { return (double)samples / pixels; }
};

// Draws the costs as lines of text and a bar divided into the parts. Returns the rectangle covered.
Rect drawCosts(Canvas &canvas, int x, int y, const PictureCosts &costs);

// The colour for a number of samples a pixel: dark blue at 1/16 and below, then one step per doubling through
// violet, red and orange, to white at 16 and above.
Colour heatOf(float samples);

// Draws the map of samples over the picture, whose brightness shows through. For a pixel with fewer than two
// samples it shows the mean of a square with sides of up to 8 pixels.
void drawHeat(Canvas &canvas, const std::vector<uint32_t> &samples);
// Draws the scale of the map's colours. Returns the rectangle covered.
Rect drawHeatLegend(Canvas &canvas, int x, int y);

} // namespace odraz::maker
