#include "maker/panel/strip.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odraz::maker {

// --- Layout ---

double Strip::timeAt(double x) const {
    return std::clamp(from + (x - area.x) / area.width * (to - from), 0., end);
}
double Strip::xOf(double time) const { return area.x + (time - from) / (to - from) * area.width; }

void Strip::zoom(double x, double factor) {
    constexpr double kShortest = 2;
    double length = std::clamp((to - from) * factor, std::min(kShortest, end), end), at = timeAt(x);
    from = std::clamp(at - (at - from) / (to - from) * length, 0., end - length);
    to = from + length;
}

void Strip::follow(double time) {
    double length = to - from;
    if (time >= from && time <= to) return;
    from = std::clamp(time - length * 0.1, 0., end - length);
    to = from + length;
}

// The parts' heights from top to bottom, in units of the text size
static constexpr float kNames = 2.1f, kEvents = 1.1f, kKeys = 0.9f;

Strip stripOf(int width, int height, double end) {
    int tall = (int)std::lround(textSize(height) * (kNames + kEvents + kKeys));
    if (width < 240 || height < tall * 2) return {{0, height, width, 0}, end, 0, end};
    return {{0, height - tall, width, tall}, end, 0, end};
}

const EventInfo *eventNear(const Strip &strip, const Content &content, double x) {
    const EventInfo *nearest = nullptr;
    double least = 6; // pixels
    for (const EventInfo &e : content.events)
        if (double distance = std::abs(strip.xOf(e.at) - x); distance < least) least = distance, nearest = &e;
    return nearest;
}

// --- Drawing ---

namespace {

struct Drawing {
    Canvas &canvas;
    const Strip &strip;
    const Content &content;
    float size = textSize(canvas.height());
    int names = strip.area.y, events = names + (int)(kNames * size), keys = events + (int)(kEvents * size);

    float x(double time) const { return (float)strip.xOf(time); }
    Rect between(double from, double to, int top, int bottom) const {
        int left = (int)std::clamp(std::lround(strip.xOf(from)), 0L, (long)canvas.width()),
            right = (int)std::clamp(std::lround(strip.xOf(to)), 0L, (long)canvas.width());
        return {left, top, right - left, bottom - top};
    }
    void upright(double time, int top, int bottom, Colour colour, float opacity) const {
        canvas.fill({(int)std::lround(strip.xOf(time)), top, 1, bottom - top}, colour, opacity);
    }

    void drawScenes() const {
        const auto &shots = content.shots;
        for (size_t i = 0, next; i < shots.size(); i = next) {
            for (next = i + 1; next < shots.size() && shots[next].scene == shots[i].scene; ++next)
                upright(shots[next].from, names + (int)(size * 1.2f), events, kInk, 0.35f);
            Rect r = between(shots[i].from, shots[next - 1].to, names, events - 1);
            canvas.fill(r, shots[i].scene % 2 ? Colour{52, 52, 60} : Colour{38, 38, 45}, 0.9f);
            std::string name = sceneName(shots[i].scene);
            if (widthOf(name, size * 0.85f) + 8 < (float)r.width)
                canvas.text(name, (float)r.x + 5, (float)names + size * 1.35f, size * 0.85f, kInk);
        }
    }
    void drawBars() const {
        double bar = kRowsPerBar / kRowsPerSecond, wide = x(bar) - x(0);
        if (wide < 4) return;
        for (double t = 0; t <= content.end; t += wide > 60 ? kBeat : bar) {
            bool whole = std::fmod(t + 1e-6, bar) < 1e-3, four = std::fmod(t + 1e-6, bar * 4) < 1e-3;
            upright(t, events, strip.area.bottom(), kInk, four ? 0.22f : whole ? 0.11f : 0.05f);
        }
    }
    void drawEvents() const {
        float middle = (float)events + kEvents * size * 0.5f;
        for (const EventInfo &e : content.events)
            canvas.line(x(e.at), middle, x(e.at), middle, e.heard ? size * 0.56f : size * 0.36f,
                        e.heard ? kWarm : kFaint);
    }
    void drawKeys() const {
        float middle = (float)keys + kKeys * size * 0.5f, arm = std::max(size * 0.22f, 1.5f);
        for (const ShotInfo &s : content.shots) {
            CameraPath path = *s.path;
            for (int i = 0; i < path.count; ++i) {
                double t = s.story + path.keys[i].row / kRowsPerSecond;
                if (t < s.from - 1e-6 || t > s.to + 1e-6) continue; // outside the shot
                canvas.line(x(t), middle - arm, x(t), middle + arm, 1.6f, kCold);
            }
        }
    }
    void drawLoop(const Loop &loop) const {
        if (!loop.on()) return;
        canvas.fill(between(loop.from, loop.to, names, strip.area.bottom()), kWarm, 0.22f);
        for (double t : {loop.from, loop.to})
            canvas.fill({(int)std::lround(strip.xOf(t)) - 1, names, 2, strip.area.height}, kWarm, 0.9f);
    }
    // Shows the time at the pointer and the nearest event
    void drawPointer(double px) const {
        if (px < 0) return;
        double t = strip.timeAt(px);
        upright(t, names, strip.area.bottom(), kInk, 0.5f);
        char text[96];
        const EventInfo *event = eventNear(strip, content, px);
        std::snprintf(text, sizeof text, "%d:%05.2f  bar %d  row %.1f%s%s", (int)t / 60, std::fmod(t, 60),
                      (int)(t * kRowsPerSecond / kRowsPerBar), t * kRowsPerSecond, event ? "  " : "",
                      event ? inWords(*event).c_str() : "");
        float wide = widthOf(text, size) + size,
              left = std::clamp((float)px - wide * 0.5f, 0.f, std::max((float)canvas.width() - wide, 0.f));
        canvas.fill({(int)left, names - (int)(size * 2.2f), (int)wide, (int)(size * 2)}, kGround, 0.85f);
        canvas.text(text, left + size * 0.5f, (float)names - size * 0.9f, size, kInk);
    }
};

} // namespace

void drawStrip(Canvas &canvas, const Strip &strip, const Content &content, const Loop &loop, double time,
               double pointer) {
    if (!strip.area.height) return;
    Drawing d = {canvas, strip, content};
    canvas.fill(strip.area, kGround, 0.82f);
    d.drawScenes();
    d.drawBars();
    d.drawEvents();
    d.drawKeys();
    d.drawLoop(loop);
    float x = d.x(time);
    canvas.line(x, (float)strip.area.y, x, (float)strip.area.bottom(), 1.8f, {255, 255, 255});
    d.drawPointer(pointer);
}

} // namespace odraz::maker
