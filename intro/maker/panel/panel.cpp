#include "maker/panel/panel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace odraz::maker {

Panel::Panel(int width, int height, double rate, int64_t (*clock)())
    : width(width), height(height), rate(rate), clock(clock) {
    strip = stripOf(width, height, 0);
    learn();
    probe.clock = clock;
}

void Panel::learn() {
    film = &inspector();
    content = contentOf(*film);
    if (content.end != strip.end) strip = stripOf(width, height, content.end);
    if (stretch.to > content.end) stretch = {};
    otherKey = differenceKey = {};
}

// --- The picture ---

Panel::Key Panel::keyOf(const PictureRequest &m) const {
    Key key = {m.time, (double)m.quality.id, (double)other};
    if (m.camera) key.insert(key.end(), &m.camera->row, &m.camera->row + sizeof(CameraKey) / sizeof(float));
    return key;
}

Picture Panel::picture(Intro &intro, const PictureRequest &m) {
    now = m.time;
    if (!shown) {
        Picture p = odraz::picture(intro, 0, m.time, m.quality, m.camera);
        Canvas canvas(p);
        if (help) drawHelp(canvas);
        return p;
    }
    if (!envelope.started()) envelope.start(*film, content.end);
    if (ghost && inset().width) makeGhost(intro, m);
    waits = (split || differs) && !makeOther(intro, m);
    Picture p = makePicture(intro, m);
    if (split || differs) watchForChanges(p, m);
    if (differs && !waits) makeDifference(p, m);
    if (materials) swatches.look(*film, intro, (int)(textSize(height) * 4.2f));
    draw(p, m);
    return p;
}

// The film's picture, with its costs measured
Picture Panel::makePicture(Intro &intro, const PictureRequest &m) {
    std::fill(std::begin(probe.spent), std::end(probe.spent), 0);
    probe.samples = nullptr;
    if (heated) {
        heat.assign((size_t)width * (size_t)height, 0);
        probe.samples = heat.data();
        probe.width = width, probe.height = height;
    }
    film->watch(&probe);
    int64_t begin = clock();
    Picture p = odraz::picture(intro, 0, m.time, m.quality, m.camera);
    costs.whole = (double)(clock() - begin) * 1e-6;
    film->watch(nullptr);
    for (int i = 0; i < (int)Cost::Count; ++i) costs.milliseconds[i] = (double)probe.spent[i] * 1e-6;
    costs.samples = samplesTaken(intro);
    costs.pixels = width * height;
    return p;
}

static CameraKey cameraOf(const PictureRequest &m) { return m.camera ? *m.camera : cameraAt(m.time); }

// The scene from outside, traced in few pixels: the engine scales it up, this scales it down to the inset
void Panel::makeGhost(Intro &intro, const PictureRequest &m) {
    Rect r = inset();
    CameraKey from = outside(content.shotAt(m.time), cameraOf(m), place);
    TracedSize few = {r.width, r.height};
    if (width > kMostEnlarged) few = {};
    Probe meter;
    meter.clock = clock, meter.brightens = true;
    film->watch(&meter);
    Picture p = odraz::picture(intro, 0, m.time, kQualities[(int)QualityName::Draft], &from, few);
    film->watch(nullptr);
    ghostPicture.width = r.width, ghostPicture.height = r.height;
    ghostPicture.rgba.resize((size_t)r.width * (size_t)r.height * 4);
    uint8_t *to = ghostPicture.rgba.data();
    for (int y = 0; y < r.height; ++y)
        for (int x = 0; x < r.width; ++x, to += 4) {
            ptrdiff_t at = (ptrdiff_t)((2 * y + 1) * height / (2 * r.height)) * width +
                           (2 * x + 1) * width / (2 * r.width);
            std::memcpy(to, p.rgba + at * 4, 4);
        }
}

// False until there is one. The reference takes many seconds: it is traced for the second picture of a
// moment, when the first has announced it
bool Panel::makeOther(Intro &intro, const PictureRequest &m) {
    Key key = keyOf(m), before = lastKey;
    lastKey = key;
    key[1] = (double)other; // it does not depend on the first one
    if (otherKey == key) return true;
    if (other == QualityName::Reference && !(before == lastKey)) return false;
    otherKey = key;
    ++others;
    otherPicture = Kept::of(odraz::picture(intro, 0, m.time, kQualities[(int)other], m.camera));
    return true;
}

// If a moment looks different the second time, the film was edited: the other picture is traced again
void Panel::watchForChanges(const Picture &p, const PictureRequest &m) {
    Key key = keyOf(m);
    bool edited = lastPictureKey == key && lastPicture.fits(p) &&
                  std::memcmp(lastPicture.rgba.data(), p.rgba, lastPicture.rgba.size()) != 0;
    if (edited) otherKey = differenceKey = {};
    if (edited || !(lastPictureKey == key)) lastPicture = Kept::of(p);
    lastPictureKey = key;
}

void Panel::makeDifference(const Picture &p, const PictureRequest &m) {
    Key key = keyOf(m);
    if (differenceKey == key) return;
    differenceKey = key;
    difference = differenceOf(otherPicture, p, scale);
    scale = difference.most;
}

// --- Drawing ---

// In the upper right corner, three tenths as wide as the picture
Rect Panel::inset() const {
    int wide = width * 3 / 10 & ~1, tall = wide * height / width, gap = (int)textSize(height);
    if (strip.area.height == 0 || wide < 64) return {0, 0, 0, 0};
    return {width - wide - gap, gap, wide, tall};
}

void Panel::drawInset(Canvas &canvas, const PictureRequest &m) {
    Rect r = inset();
    if (!r.width || !ghost) return;
    const ShotInfo &shot = content.shotAt(m.time);
    CameraKey camera = cameraOf(m);
    canvas.fill({r.x - 1, r.y - 1, r.width + 2, r.height + 2}, kFaint);
    canvas.put(r.x, r.y, ghostPicture.rgba.data(), r.width, r.height);
    drawGhost(canvas, projectionOf(outside(shot, camera, place), r), shot, camera,
              (float)width / (float)height);
}

void Panel::drawComparison(Canvas &canvas, const PictureRequest &m) {
    std::string a = m.quality.name, b = kQualities[(int)other].name;
    if (waits)
        drawLabel(canvas, b + (lastKey == keyOf(m) ? " is being traced" : " is traced where the film pauses"),
                  (float)width * 0.5f, Align::Centre);
    else if (differs)
        drawDifference(canvas, difference, a + " against " + b);
    else if (split)
        drawSplit(canvas, otherPicture, (int)std::lround(divider * width), a, b);
}

void Panel::draw(const Picture &p, const PictureRequest &m) {
    Canvas canvas(p);
    if (heated && !differs) drawHeat(canvas, heat);
    drawComparison(canvas, m);
    int gap = (int)textSize(height), y = gap;
    bool room = strip.area.height > 0;
    if (room && costly) y = drawCosts(canvas, gap, y, costs).bottom() + gap;
    if (room && heated && !differs) y = drawHeatLegend(canvas, gap, y).bottom() + gap;
    if (room && materials) swatches.draw(canvas, gap, y);
    drawInset(canvas, m);
    // The level since the last picture
    int64_t moment = clock();
    double passed = last ? (double)(moment - last) * 1e-9 : 0;
    last = moment;
    bool ran = m.time > heardTo && m.time < heardTo + 0.5;
    meter.hear(ran ? envelope.most(heardTo, m.time) : Level{}, passed);
    heardTo = m.time;
    strip.follow(m.time);
    double pointer = mouseX >= 0 && strip.area.holds(mouseX, mouseY) ? mouseX : -1;
    drawStrip(canvas, strip, content, envelope, stretch, m.time, pointer);
    int wide = gap * 2;
    if (room) drawMeter(canvas, {width - wide - gap, strip.area.y - gap * 12, wide, gap * 11}, meter);
    if (help) drawHelp(canvas);
}

} // namespace odraz::maker
