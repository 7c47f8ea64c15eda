#include "maker/panel/panel.h"

#include <algorithm>

namespace odraz::maker {

Panel::Panel(int width, int height, double rate, int64_t (*clock)())
    : width(width), height(height), rate(rate), clock(clock) {
    strip = stripOf(width, height, 0);
    renew();
    probe.clock = clock;
}

void Panel::renew() {
    film = &inspector();
    content = contentOf(*film);
    if (content.end != strip.end) strip = stripOf(width, height, content.end);
    if (stretch.to > content.end) stretch = {};
}

// --- The picture ---

Picture Panel::picture(Intro &intro, const PictureRequest &m) {
    now = m.time;
    Picture p = shown ? makePicture(intro, m) : odraz::picture(intro, 0, m.time, m.quality, m.camera);
    Canvas canvas(p);
    if (shown) draw(canvas, m.time);
    if (help) drawHelp(canvas);
    return p;
}

// Makes the film's picture and measures its costs
Picture Panel::makePicture(Intro &intro, const PictureRequest &m) {
    std::fill(std::begin(probe.spent), std::end(probe.spent), 0);
    probe.samples = nullptr;
    if (heatShown) {
        heat.assign((size_t)width * (size_t)height, 0);
        probe.samples = heat.data();
        probe.width = width, probe.height = height;
    }
    film->watch(&probe);
    int64_t begin = clock();
    Picture p = odraz::picture(intro, 0, m.time, m.quality, m.camera);
    costs.whole = (double)(clock() - begin) * 1e-6;
    film->watch(nullptr);
    for (int i = 0; i < (int)PicturePart::Count; ++i) costs.milliseconds[i] = (double)probe.spent[i] * 1e-6;
    costs.samples = samplesTaken(intro);
    costs.pixels = width * height;
    return p;
}

void Panel::draw(Canvas &canvas, double time) {
    if (heatShown) drawHeat(canvas, heat);
    int gap = (int)textSize(height), y = gap;
    bool room = strip.area.height > 0;
    if (room && costsShown) y = drawCosts(canvas, gap, y, costs).bottom() + gap;
    if (room && heatShown) drawHeatLegend(canvas, gap, y);
    strip.follow(time);
    double pointer = mouseX >= 0 && strip.area.holds(mouseX, mouseY) ? mouseX : -1;
    drawStrip(canvas, strip, content, stretch, time, pointer);
}

} // namespace odraz::maker
