// The panel's input: actions and the mouse.
#include "maker/panel/panel.h"

#include <algorithm>
#include <cmath>

namespace odraz::maker {

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
    case Action::EventOn:
        return step(stepTo(time, content.eventTimes(), action == Action::EventOn ? 1 : -1));
    case Action::Count:
        return;
    }
}

// --- The mouse ---

void Panel::press(double x, double y, Button button) {
    mouseX = x, mouseY = y;
    if (!shown) return;
    if (!strip.area.holds(x, y)) return;
    loopFrom = strip.timeAt(x);
    grabbed = button == Button::Right ? Grab::LoopEnd : Grab::Scrub;
    if (grabbed == Grab::Scrub) seek(loopFrom);
    if (grabbed == Grab::LoopEnd) stretch = {};
}

void Panel::move(double x, double y) {
    double dx = x - mouseX;
    mouseX = x, mouseY = y;
    switch (grabbed) {
    case Grab::None:
        break;
    case Grab::Scrub:
        seek(strip.timeAt(x));
        break;
    case Grab::LoopEnd:
        if (dx != 0) stretch = loopBetween(loopFrom, strip.timeAt(x), content.end);
        break;
    }
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
