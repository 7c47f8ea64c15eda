#include "maker/panel/compare.h"

#include "tools/picture/flip.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odraz::maker {

Kept Kept::of(const Picture &p) {
    return {p.width, p.height, {p.rgba, p.rgba + (size_t)p.width * (size_t)p.height * 4}};
}

static pictures::SeenPicture seen(const uint8_t *rgba, int width, int height) {
    size_t pixels = (size_t)width * (size_t)height;
    std::vector<uint8_t> rgb(pixels * 3);
    for (size_t i = 0; i < pixels; ++i) std::copy_n(rgba + i * 4, 3, rgb.data() + i * 3);
    return pictures::see(rgb, width, height);
}

Difference differenceOf(const Kept &reference, const Picture &test, float least) {
    Difference d;
    if (!reference.fits(test)) return d;
    d.flip = pictures::flip(seen(reference.rgba.data(), test.width, test.height),
                            seen(test.rgba, test.width, test.height));
    for (float f : d.flip) d.mean += f;
    d.mean /= (double)d.flip.size();
    std::vector<float> sorted = d.flip;
    auto high = sorted.end() - 1 - (ptrdiff_t)(sorted.size() / 500);
    std::nth_element(sorted.begin(), high, sorted.end());
    for (float most : {0.5f, 0.2f, 0.1f, 0.05f})
        if (*high <= most && most >= least) d.most = most;
    return d;
}

void drawLabel(Canvas &canvas, const std::string &text, float x, Align align) {
    float size = textSize(canvas.height()), wide = widthOf(text, size) + size * 1.2f;
    float left = align == Align::Right ? x - wide : align == Align::Centre ? x - wide * 0.5f : x;
    canvas.fill({(int)left, (int)(size * 0.6f), (int)wide, (int)(size * 2)}, kGround, 0.8f);
    canvas.text(text, left + size * 0.6f, size * 1.95f, size, kInk);
}

void drawSplit(Canvas &canvas, const Kept &other, int column, const std::string &left,
               const std::string &right) {
    column = std::clamp(column, 0, canvas.width());
    for (int y = 0; y < canvas.height(); ++y)
        std::copy_n(other.rgba.data() + ((ptrdiff_t)y * other.width + column) * 4,
                    (canvas.width() - column) * 4, canvas.at(0, y) + (ptrdiff_t)column * 4);
    canvas.fill({column - 1, 0, 2, canvas.height()}, kInk, 0.85f);
    canvas.dot((float)column, (float)canvas.height() * 0.5f, textSize(canvas.height()) * 0.5f, kInk);
    float gap = textSize(canvas.height()) * 0.6f;
    drawLabel(canvas, left, (float)column - gap, Align::Right);
    drawLabel(canvas, right, (float)column + gap, Align::Left);
}

// As FLIP's own pictures: magma
Colour differenceColour(float share) {
    static constexpr Colour kStops[] = {{0, 0, 4},      {28, 16, 68},    {79, 18, 123},
                                        {129, 37, 129}, {181, 54, 122},  {229, 80, 100},
                                        {251, 135, 97}, {254, 194, 135}, {252, 253, 191}};
    return colourAt(share, kStops);
}

void drawDifference(Canvas &canvas, const Difference &d, const std::string &what) {
    if (d.flip.size() != (size_t)canvas.width() * (size_t)canvas.height()) return;
    Colour colours[256];
    for (int i = 0; i < 256; ++i) colours[i] = differenceColour((float)i / 255);
    const float *flip = d.flip.data();
    float scale = 255 / d.most;
    for (int y = 0; y < canvas.height(); ++y)
        for (int x = 0; x < canvas.width(); ++x) {
            Colour c = colours[(int)std::min(*flip++ * scale, 255.f)];
            uint8_t *p = canvas.at(x, y);
            p[0] = c.r, p[1] = c.g, p[2] = c.b;
        }
    char text[96];
    std::snprintf(text, sizeof text, "%s   flip %.4f", what.c_str(), d.mean);
    drawLabel(canvas, text, (float)canvas.width() * 0.5f, Align::Centre);
    // The scale of the colours, below it
    float size = textSize(canvas.height());
    std::snprintf(text, sizeof text, "%.3g", (double)d.most);
    int wide = (int)(size * 16), left = (canvas.width() - wide) / 2, top = (int)(size * 2.6f),
        tall = (int)(size * 1.4f), ends = (int)(std::max(widthOf("0", size), widthOf(text, size)) + size);
    canvas.fill({left - ends, top, wide + 2 * ends, tall + 2}, kGround, 0.8f);
    for (int x = 0; x < wide; ++x)
        canvas.fill({left + x, top + 1, 1, tall}, differenceColour(((float)x + 0.5f) / (float)wide));
    float base = (float)top + size * 1.25f;
    canvas.text("0", (float)left - size * 0.5f, base, size, kInk, Align::Right);
    canvas.text(text, (float)(left + wide) + size * 0.5f, base, size, kInk);
}

} // namespace odraz::maker
