#include "maker/panel/canvas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace odraz::maker {

namespace {

constexpr float kWeight = 0.125f, kTracking = 0.6f;

// A line of text as the coverage of each pixel. The baseline is `above` rows below the top.
struct Lettering {
    int width = 0, height = 0, above = 0;
    std::vector<float> cover;
};

// A letter is at most 12 units wide, plus 3.5 units of space; 12 units are `size` pixels
Lettering letter(const std::string &text, float size) {
    Lettering l;
    int stride = ((int)((float)text.size() * (15.5f + kTracking) / 12 * size) + 4 + 15) & ~7;
    l.above = (int)std::ceil(size * 1.1f) + 1;
    l.height = l.above + (int)std::ceil(size * 0.4f) + 1;
    std::vector<float> planes[3];
    for (auto &plane : planes) plane.assign((size_t)stride * (size_t)l.height, 0.f);
    Frame frame = {stride,  l.height, stride, {planes[0].data(), planes[1].data(), planes[2].data()},
                   nullptr, nullptr};
    inspector().drawText(frame, text.c_str(), 2, (float)l.above,
                         {size, kWeight, Align::Left, {1, 1, 1}, 1, kTracking});
    for (int y = 0; y < l.height; ++y)
        for (int x = 0; x < stride; ++x)
            if (planes[0][(size_t)(y * stride + x)] > 0) l.width = std::max(l.width, x + 1);
    for (int y = 0; y < l.height; ++y) {
        auto row = planes[0].begin() + y * stride;
        l.cover.insert(l.cover.end(), row, row + l.width);
    }
    return l;
}

// Caches texts, since most are the same in the next picture
const Lettering &lettering(const std::string &text, float size) {
    static std::map<std::pair<std::string, float>, Lettering> cache;
    if (cache.size() > 400) cache.clear();
    auto [at, fresh] = cache.try_emplace({text, size});
    if (fresh) at->second = letter(text, size);
    return at->second;
}

} // namespace

void Canvas::mix(int x, int y, Colour colour, float opacity) {
    uint8_t *pixel = at(x, y);
    const uint8_t to[3] = {colour.r, colour.g, colour.b};
    for (int c = 0; c < 3; ++c)
        pixel[c] = (uint8_t)((float)pixel[c] + ((float)to[c] - (float)pixel[c]) * opacity + 0.5f);
}

void Canvas::fill(Rect r, Colour colour, float opacity) {
    int x0 = std::max(r.x, 0), x1 = std::min(r.right(), width()), y0 = std::max(r.y, 0),
        y1 = std::min(r.bottom(), height());
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) mix(x, y, colour, opacity);
}

void Canvas::line(float x0, float y0, float x1, float y1, float wide, Colour colour, float opacity) {
    if (!std::isfinite(x0 + y0 + x1 + y1)) return;
    float margin = wide * 0.5f + 1, dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
    auto within = [](float v, int limit) { return (int)std::clamp(v, 0.f, (float)limit); };
    int top = within(std::min(y0, y1) - margin, height()),
        bottom = within(std::max(y0, y1) + margin + 1, height());
    for (int y = top; y < bottom; ++y) {
        // Visit only pixels near the line
        float from = std::min(x0, x1), to = std::max(x0, x1), py = (float)y + 0.5f;
        if (std::abs(dy) > 1) {
            float a = x0 + (py - margin - y0) / dy * dx, b = x0 + (py + margin - y0) / dy * dx;
            from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
        }
        int left = within(from - margin, width()), right = within(to + margin + 1, width());
        for (int x = left; x < right; ++x) {
            float px = (float)x + 0.5f,
                  along = square > 0 ? std::clamp(((px - x0) * dx + (py - y0) * dy) / square, 0.f, 1.f) : 0;
            float distance = std::hypot(px - x0 - along * dx, py - y0 - along * dy);
            float cover = std::clamp(wide * 0.5f + 0.5f - distance, 0.f, 1.f) * opacity;
            if (cover > 0) mix(x, y, colour, cover);
        }
    }
}

void Canvas::text(const std::string &text, float x, float y, float size, Colour colour, Align align) {
    if (text.empty()) return;
    const Lettering &l = lettering(text, size);
    x -= align == Align::Centre ? (float)l.width * 0.5f : align == Align::Right ? (float)l.width : 0;
    int left = (int)std::lround(x), top = (int)std::lround(y) - l.above;
    for (int j = std::max(-top, 0); j < std::min(l.height, height() - top); ++j)
        for (int i = std::max(-left, 0); i < std::min(l.width, width() - left); ++i)
            if (float cover = l.cover[(size_t)(j * l.width + i)]; cover > 0)
                mix(left + i, top + j, colour, cover);
}

float textSize(int height) { return std::clamp((float)height / 72, 6.f, 24.f); }

float widthOf(const std::string &text, float size) {
    return text.empty() ? 0 : (float)lettering(text, size).width;
}

void drawStatus(const Picture &p, const std::string &text, float done) {
    constexpr float kSize = 12;
    constexpr int kLineHeight = 26, kIndent = 12, kBarHeight = 4;
    std::vector<std::string> lines;
    float letter = widthOf(text, kSize) / (float)text.size();
    auto most = (size_t)std::max((float)(p.width - 2 * kIndent) / letter * 0.9f, 1.f);
    for (size_t at = 0, length; at < text.size(); at += length) {
        length = std::min(most, text.size() - at);
        size_t blank = text.rfind(' ', at + length - 1);
        if (at + length < text.size() && blank != text.npos && blank > at + length / 2)
            length = blank + 1 - at;
        lines.push_back(text.substr(at, length));
    }
    Canvas canvas(p);
    int tall = (int)lines.size() * kLineHeight, top = p.height - kBarHeight - tall;
    canvas.fill({0, top, p.width, tall}, {0, 0, 0}, 0.7f);
    for (const std::string &line : lines)
        canvas.text(line, kIndent, (float)((top += kLineHeight) - 8), kSize, {255, 255, 255});
    canvas.fill({0, p.height - kBarHeight, (int)((float)p.width * done), kBarHeight},
                {217, 122, 60}); // copper
}

} // namespace odraz::maker
