// Input to the panel: actions and the mouse.
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
    case Action::Ghost:
        return toggle(ghost);
    case Action::Heat:
        return toggle(heated);
    case Action::Materials:
        return toggle(materials);
    case Action::Costs:
        return toggle(costly);
    case Action::Split:
        return toggle(split);
    case Action::Difference:
        toggle(differs);
        scale = 0;
        stop |= differs;
        return;
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
    case Action::OtherDraft:
    case Action::OtherPlay:
    case Action::OtherFilm:
    case Action::OtherReference:
        other = (QualityName)((int)action - (int)Action::OtherDraft);
        scale = 0;
        split = shown = true;
        return;
    case Action::Count:
        return;
    }
}

// --- The mouse ---

void Panel::press(double x, double y, Button button) {
    mouseX = x, mouseY = y;
    if (!shown) return;
    if (strip.area.holds(x, y)) {
        loopFrom = strip.timeAt(x);
        grabbed = button == Button::Right ? Grab::LoopEnd : Grab::Scrub;
        if (grabbed == Grab::Scrub) seek(loopFrom);
        if (grabbed == Grab::LoopEnd) stretch = {};
    } else if (button == Button::Left && ghost && inset().holds(x, y)) {
        grabbed = Grab::Orbit;
    } else if (button == Button::Left && split && std::abs(x - divider * width) < textSize(height)) {
        grabbed = Grab::Divider;
    }
}

void Panel::move(double x, double y) {
    double dx = x - mouseX, dy = y - mouseY;
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
    case Grab::Orbit:
        place.orbit((float)dx * -0.5f, (float)dy * 0.5f);
        break;
    case Grab::Divider:
        divider = std::clamp(x / width, 0., 1.);
        break;
    }
}

void Panel::release() { grabbed = Grab::None; }

void Panel::wheel(double x, double y, double turns) {
    if (!shown) return;
    if (strip.area.holds(x, y))
        strip.zoom(x, std::pow(0.8, turns));
    else if (ghost && inset().holds(x, y))
        place.zoom((float)std::pow(1.15, turns));
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
    // While it scrubs, the time stays where the mouse is
    if (grabbed != Grab::Scrub) wanted = -1;
    now = time;
}

} // namespace odraz::maker
