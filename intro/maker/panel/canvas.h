// Draws on a developed picture: rectangles, lines, and text in the film's font.
#pragma once

#include "maker/panel/inspector.h"

#include <string>

namespace odraz::maker {

struct Colour {
    uint8_t r, g, b; // sRGB
};
inline constexpr Colour kInk = {236, 232, 224}, kFaint = {150, 146, 140}, kGround = {14, 14, 17},
                        kWarm = {222, 130, 70}, kCold = {110, 160, 220};

struct Rect {
    int x, y, width, height; // pixels, from the top left

    bool holds(double px, double py) const { return px >= x && py >= y && px < x + width && py < y + height; }
    int right() const { return x + width; }
    int bottom() const { return y + height; }
};

// A picture to draw on. Shapes are clipped at its edges.
class Canvas {
public:
    explicit Canvas(const Picture &picture) : picture(picture) {}
    int width() const { return picture.width; }
    int height() const { return picture.height; }

    // Opacity: 0 .. 1, where 0 leaves the picture as it is.
    void fill(Rect where, Colour colour, float opacity = 1);
    void line(float x0, float y0, float x1, float y1, float width, Colour colour, float opacity = 1);
    // One line of text with its baseline at y; `size` is the height of a digit, in pixels. The film's font
    // has only letters, digits and . , : - + /
    void text(const std::string &text, float x, float y, float size, Colour colour,
              Align align = Align::Left);

    // One pixel; it must be in the picture.
    uint8_t *at(int x, int y) const { return picture.rgba + ((ptrdiff_t)y * picture.width + x) * 4; }
    void mix(int x, int y, Colour colour, float opacity);

private:
    Picture picture;
};

// The size of the panel's text in a picture of this height.
float textSize(int height);

// The width of a line of text, in pixels.
float widthOf(const std::string &text, float size);

// Draws lines of text on a dark ground at the lower edge of a picture, above a progress bar. `done`: 0 .. 1.
void drawStatus(const Picture &picture, const std::string &text, float done);

} // namespace odraz::maker
