#include "maker/panel/panel.h"

#include <algorithm>
#include <cmath>

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

// --- Actions ---

void Panel::seek(double to) { wanted = std::clamp(to, 0., content.end); }

void Panel::act(Action action) {
    double time = wanted >= 0 ? wanted : now, bar = kRowsPerBar / kRowsPerSecond;
    auto toggle = [&](bool &part) {
        part = !shown || !part;
        shown = true;
    };
    auto step = [&](double to) {
        seek(to);
        stop = true;
    };
    switch (action) {
    case Action::Panel:
        shown = !shown;
        return;
    case Action::Help:
        help = !help;
        return;
    case Action::Heat:
        return toggle(heatShown);
    case Action::Costs:
        return toggle(costsShown);
    case Action::LoopShot: {
        const ShotInfo &shot = content.shotAt(time);
        stretch = stretch.on() ? Loop{} : loopBetween(shot.from, shot.to, content.end);
        return;
    }
    case Action::PictureBack:
    case Action::PictureOn:
        return step(stepBy(time, 1 / rate, action == Action::PictureOn ? 1 : -1, content.end));
    case Action::BarBack:
    case Action::BarOn:
        return seek(stepBy(time, bar, action == Action::BarOn ? 1 : -1, content.end));
    case Action::EventBack:
    case Action::EventOn: {
        std::vector<double> times;
        for (const EventInfo &e : content.events) times.push_back(e.at);
        return step(stepTo(time, times, action == Action::EventOn ? 1 : -1));
    }
    case Action::Count:
        return;
    }
}

// --- The mouse ---

void Panel::press(double x, double y, Button button) {
    mouseX = x, mouseY = y;
    if (!shown || !strip.area.holds(x, y)) return;
    loopFrom = strip.timeAt(x);
    grabbed = button == Button::Right ? Grab::LoopEnd : Grab::Scrub;
    if (grabbed == Grab::Scrub) seek(loopFrom);
    if (grabbed == Grab::LoopEnd) stretch = {};
}

void Panel::move(double x, double y) {
    double dx = x - mouseX;
    mouseX = x, mouseY = y;
    if (grabbed == Grab::Scrub) seek(strip.timeAt(x));
    if (grabbed == Grab::LoopEnd && dx != 0) stretch = loopBetween(loopFrom, strip.timeAt(x), content.end);
}

void Panel::release() { grabbed = Grab::None; }

void Panel::wheel(double x, double y, double turns) {
    if (shown && strip.area.holds(x, y)) strip.zoom(x, std::pow(0.8, turns));
}

// --- To the host ---

void Panel::steer(double &time, bool &paused, bool &sought) {
    if (stop) paused = true;
    if (wanted >= 0) {
        sought = sought || time != wanted;
        time = wanted;
    } else if (double to = looped(stretch, time); !paused && grabbed == Grab::None && to != time) {
        time = to;
        sought = true;
    }
    stop = false;
    // While scrubbing, the time stays at the mouse
    if (grabbed != Grab::Scrub) wanted = -1;
    now = time;
}

} // namespace odraz::maker
