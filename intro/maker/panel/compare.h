// Two qualities of the same moment, side by side, and the difference that an eye sees between them (FLIP).
#pragma once

#include "maker/panel/canvas.h"

#include <vector>

namespace odraz::maker {

// A picture that is kept: four bytes a pixel.
struct Kept {
    int width = 0, height = 0;
    std::vector<uint8_t> rgba;

    static Kept of(const Picture &picture);
    bool fits(const Picture &p) const { return width == p.width && height == p.height; }
};

// FLIP at every pixel, 0 .. 1, and its mean (tools/measure/detect/flip.h).
struct Difference {
    std::vector<float> flip;
    double mean = 0;
    float most = 1; // what the map shows brightest: one pixel in 500 may be above
};
// `least`: of what was shown before, so that the same colour goes on meaning the same. Difference::most is
// the first of 0.05, 0.1, 0.2, 0.5 and 1 that is enough, and no less than this.
Difference differenceOf(const Kept &reference, const Picture &test, float least = 0);

// A line of text on a dark ground at the upper edge, from x on, up to it, or around it.
void drawLabel(Canvas &canvas, const std::string &text, float x, Align align);

// Shows `other` to the right of a column, and which is which at the upper edge. Both have the same size.
void drawSplit(Canvas &canvas, const Kept &other, int column, const std::string &left,
               const std::string &right);

// Shows the map instead of the picture: black where nothing is seen, up to bright yellow at Difference::most;
// and a scale of its colours.
void drawDifference(Canvas &canvas, const Difference &difference, const std::string &what);
Colour differenceColour(float share); // of Difference::most

} // namespace odraz::maker
