// Two qualities of the same moment, side by side, and the difference that an eye sees between them (FLIP).
#pragma once

#include "maker/panel/canvas.h"

#include <vector>

namespace odraz::maker {

// A copy of a picture: four bytes a pixel.
struct Kept {
    int width = 0, height = 0;
    std::vector<uint8_t> rgba;

    static Kept of(const Picture &picture);
    bool fits(const Picture &p) const { return width == p.width && height == p.height; }
};

// FLIP at every pixel, 0 .. 1, and its mean (tools/picture/flip.h).
struct Difference {
    std::vector<float> flip;
    double mean = 0;
    float most = 1; // the brightest colour of the map: one pixel in 500 may be above
};
// Difference::most is the first of 0.05, 0.1, 0.2, 0.5 and 1 that is enough, and at least `least`: that of
// the map before, so that a colour keeps its meaning.
Difference differenceOf(const Kept &reference, const Picture &test, float least = 0);

// A line of text on a dark ground at the upper edge: to the right of x, to its left, or centred on it.
void drawLabel(Canvas &canvas, const std::string &text, float x, Align align);

// Shows `other` to the right of a column, and the names of both at the upper edge. Both have the same size.
void drawSplit(Canvas &canvas, const Kept &other, int column, const std::string &left,
               const std::string &right);

// Replaces the picture by the map: black for no difference, bright yellow for Difference::most; with a scale
// of its colours.
void drawDifference(Canvas &canvas, const Difference &difference, const std::string &what);
Colour differenceColour(float share); // of Difference::most

} // namespace odraz::maker
