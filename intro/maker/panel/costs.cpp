#include "maker/panel/costs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odraz::maker {

static constexpr struct {
    const char *name;
    Colour colour;
} kParts[(int)PicturePart::Count] = {{"posing", {150, 146, 140}},
                                     {"tracing", {222, 130, 70}},
                                     {"glare", {236, 210, 120}},
                                     {"development", {110, 160, 220}},
                                     {"enlarging", {120, 190, 140}}};

Rect drawCosts(Canvas &canvas, int x, int y, const PictureCosts &costs) {
    float size = textSize(canvas.height());
    int step = (int)(size * 1.75f), wide = (int)(size * 20),
        lines = (int)PicturePart::Count + (costs.milliseconds[(int)PicturePart::Enlarging] > 0 ? 2 : 1);
    Rect r = {x, y, wide, step * lines + (int)(size * 2)};
    canvas.fill(r, kGround, 0.78f);
    float left = (float)x + size * 0.8f, right = (float)r.right() - size * 0.8f,
          base = (float)y + size * 1.7f;
    auto line = [&](const std::string &what, const char *format, double value, Colour colour) {
        char text[32];
        std::snprintf(text, sizeof text, format, value);
        canvas.text(what, left, base, size, colour);
        canvas.text(text, right, base, size, kInk, Align::Right);
        base += (float)step;
    };
    line("picture, ms", "%.1f", costs.whole, kInk);
    for (int i = 0; i < (int)PicturePart::Count; ++i)
        if (i != (int)PicturePart::Enlarging || costs.milliseconds[i] > 0)
            line(kParts[i].name, "%.2f", costs.milliseconds[i], kParts[i].colour);
    line("samples a pixel", "%.3f", costs.samplesAPixel(), kInk);
    // Draw the bar
    float total = (float)std::max(costs.whole, 1e-3), at = left, per = (right - left) / total;
    int top = (int)(base - size * 0.9f), tall = std::max((int)(size * 0.7f), 2);
    canvas.fill({(int)left, top, (int)(right - left), tall}, kInk, 0.15f);
    for (int i = 0; i < (int)PicturePart::Count; ++i) {
        float to = std::min(at + (float)costs.milliseconds[i] * per, right);
        canvas.fill({(int)std::lround(at), top, (int)(std::lround(to) - std::lround(at)), tall},
                    kParts[i].colour);
        at = to;
    }
    return r;
}

// Returns a colour of a ramp: stops[0] at share 0, stops[8] at share 1.
static Colour colourAt(float share, const Colour (&stops)[9]) {
    float at = std::clamp(share, 0.f, 1.f) * 8;
    int i = std::min((int)at, 7);
    auto between = [&](uint8_t a, uint8_t b) {
        return (uint8_t)((float)a + ((float)b - (float)a) * (at - (float)i) + 0.5f);
    };
    const Colour &a = stops[i], &b = stops[i + 1];
    return {between(a.r, b.r), between(a.g, b.g), between(a.b, b.b)};
}

Colour heatOf(float samples) {
    static constexpr Colour kStops[] = {{10, 14, 60},   {36, 24, 110},  {84, 26, 130},
                                        {140, 34, 120}, {196, 54, 84},  {236, 96, 44},
                                        {250, 150, 40}, {252, 212, 96}, {255, 255, 235}};
    return colourAt((std::log2(std::max(samples, 1e-6f)) + 4) / 8, kStops); // from 1/16 to 16
}

namespace {

// A pixel's colour shows the samples per pixel of the smallest square around it, of 1, 2, 4 or 8 pixels a
// side, that has at least two samples. So it shows the density where few pixels are traced.
struct HeatMap {
    const std::vector<uint32_t> &samples;
    int width, height;

    uint32_t sum(int x0, int y0, int x1, int y1) const {
        uint32_t n = 0;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) n += samples[(size_t)y * (size_t)width + (size_t)x];
        return n;
    }
    // Colours the square of `size` pixels at (x, y), with n samples, or its quarters. `f` draws a part.
    template <class F> void divide(int x, int y, int size, uint32_t n, const F &f) const {
        int x1 = std::min(x + size, width), y1 = std::min(y + size, height);
        int half = size / 2;
        float mean = (float)n / (float)((x1 - x) * (y1 - y));
        if (size == 1 || n < 2) return f(x, y, x1, y1, mean);
        for (int qy = y; qy < y1; qy += half)
            for (int qx = x; qx < x1; qx += half) {
                int rx = std::min(qx + half, x1), ry = std::min(qy + half, y1);
                uint32_t inside = sum(qx, qy, rx, ry);
                if (inside < 2 && !(half == 1 && inside)) // a single pixel is shown even with one sample
                    f(qx, qy, rx, ry, mean);
                else
                    divide(qx, qy, half, inside, f);
            }
    }
};

} // namespace

void drawHeat(Canvas &canvas, const std::vector<uint32_t> &samples) {
    int width = canvas.width(), height = canvas.height();
    if (samples.size() != (size_t)width * (size_t)height) return;
    constexpr int kOpacity = 184; // in 256ths
    HeatMap map = {samples, width, height};
    for (int top = 0; top < height; top += 8)
        for (int left = 0; left < width; left += 8) {
            uint32_t n = map.sum(left, top, std::min(left + 8, width), std::min(top + 8, height));
            map.divide(left, top, 8, n, [&](int x0, int y0, int x1, int y1, float mean) {
                Colour c = heatOf(mean);
                for (int y = y0; y < y1; ++y)
                    for (int x = x0; x < x1; ++x) {
                        uint8_t *p = canvas.at(x, y);
                        int grey = (p[0] * 3 + p[1] * 6 + p[2]) / 10 * (256 - kOpacity);
                        p[0] = (uint8_t)((grey + c.r * kOpacity) >> 8);
                        p[1] = (uint8_t)((grey + c.g * kOpacity) >> 8);
                        p[2] = (uint8_t)((grey + c.b * kOpacity) >> 8);
                    }
            });
        }
}

Rect drawHeatLegend(Canvas &canvas, int x, int y) {
    float size = textSize(canvas.height());
    int each = (int)(size * 2), tall = (int)(size * 0.8f);
    Rect r = {x, y, each * 9 + (int)(size * 1.6f), (int)(size * 5)};
    canvas.fill(r, kGround, 0.78f);
    canvas.text("samples in a pixel", (float)x + size * 0.8f, (float)y + size * 1.7f, size, kInk);
    for (int i = 0; i < 9; ++i) {
        int left = x + (int)(size * 0.8f) + i * each;
        for (int k = 0; k < each; ++k)
            canvas.fill({left + k, y + (int)(size * 2.3f), 1, tall},
                        heatOf(std::exp2((float)i - 4 + (float)k / (float)each)));
        static constexpr const char *kNumbers[9] = {"1/16", "", "1/4", "", "1", "", "4", "", "16"};
        canvas.text(kNumbers[i], (float)left, (float)y + size * 4.5f, size * 0.75f, kInk);
    }
    return r;
}

} // namespace odraz::maker
