// The loop of `view`: draws after each change until the window closes.
#include "tools/common/text.h"
#include "tools/radiosity/view/help.h"
#include "tools/radiosity/view/window.h"

#include "trace/picture/frame.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odraz::radiosity {

// Samples along a pixel's side while nothing moves. With these, edges look much like the tracer's.
static constexpr int kStillSamples = 4;

void ViewWindow::drawChanges(bool moving) {
    if (redraw) {
        picture->draw(s.camera, s.layers, moving ? 1 : kStillSamples);
        if (picture->measure(moving ? 200 : kMaxWidth, targetTone) && !measured) {
            tone.exposure = exposure(), tone.low = targetTone.low, tone.high = targetTone.high;
            measured = true;
        }
        rough = moving;
        retone = true;
    }
    if (s.layers.hemicube) pickPatch();
    redraw = false;
}

void ViewWindow::pickPatch() {
    int width, height, x = s.camera.width / 2, y = s.camera.height / 2;
    glfwGetWindowSize(window, &width, &height);
    if (s.screenshot.empty() && width > 0 && height > 0)
        x = (int)(mouseX * s.camera.width / width), y = (int)(mouseY * s.camera.height / height);
    if (!redraw && x == pointerX && y == pointerY) return;
    pointerX = x, pointerY = y;
    int found = picture->patchAt(x, y);
    if (!redraw && found == patch) return;
    patch = found;
    if (patch) picture->drawHemicube(patch, s.camera.upIsZ);
    retone = true;
}

float ViewWindow::exposure() const { return targetTone.exposure * std::exp2(s.camera.stops); }

// Adapts the exposure gradually, or at once for a screenshot. Returns whether it must go on adapting.
bool ViewWindow::adaptExposure(float seconds) {
    float stops = std::log(exposure() / tone.exposure), low = targetTone.low - tone.low,
          high = targetTone.high - tone.high,
          largest = std::max({std::fabs(stops), std::fabs(low), std::fabs(high)});
    if (largest == 0) return false;
    bool arrived = largest < 0.004f || !s.screenshot.empty();
    float share = arrived ? 1 : 1 - std::exp(-seconds / 0.15f);
    tone.exposure = arrived ? exposure() : tone.exposure * std::exp(stops * share);
    tone.low = arrived ? targetTone.low : tone.low + low * share;
    tone.high = arrived ? targetTone.high : tone.high + high * share;
    retone = true;
    return !arrived;
}

void ViewWindow::present() {
    int width, height;
    glfwGetFramebufferSize(window, &width, &height);
    picture->show(tone, s.layers, patch, height, help ? viewKeys(room) : std::vector<ViewKey>());
    glfwSwapBuffers(window);
    retone = false;
    if (s.screenshot.empty() || !solved || size == 0) return;
    pictures::writePng(s.screenshot, picture->read());
    std::printf("%s: light was shown %s\n", s.screenshot.c_str(),
                common::counted((size_t)pictures, "time").c_str());
    glfwSetWindowShouldClose(window, 1);
}

void ViewWindow::title(const std::string &step) {
    std::string text = "radiosity: " + s.name + (step.empty() ? "" : "  (" + step + ")");
    if (room) text += "  " + room->title();
    for (const ViewLayer &layer : kViewLayers)
        if (s.layers.*layer.shown) text += std::string("  ") + layer.name;
    if (tone.logarithmic) text += "  log";
    if (s.camera.stops != 0) common::append(text, "  %+g stops", (double)s.camera.stops);
    text += room ? "   [H help, W A S D Q E, mouse, wheel, 1 .. 9 [ ] - = P , . B T R C, Esc]"
                 : "   [H help, W A S D Q E, mouse, wheel, 1 2 3 4 B T R C, Esc]";
    if (text != shownTitle) glfwSetWindowTitle(window, text.c_str());
    shownTitle = text;
}

void ViewWindow::run(BackgroundSolve *solver) {
    solved = !solver;
    double last = glfwGetTime(), moved = -1;
    bool adapting = false;
    while (!glfwWindowShouldClose(window)) {
        bool hurry = adapting || retone || redraw || rough || last - moved < 0.3;
        hurry ? glfwPollEvents() : glfwWaitEventsTimeout(solver && !solved ? 0.2 : 1);
        double now = glfwGetTime();
        auto passed = (float)(now - last);
        last = now;
        if (solver) takeNews(*solver);
        title(solver ? solver->step() : "");
        int width, height;
        glfwGetFramebufferSize(window, &width, &height);
        if (s.screenshot.empty() && width > 0 && height > 0 &&
            (width != s.camera.width || height != s.camera.height))
            s.camera.width = width, s.camera.height = height, redraw = true;
        bool moving = fly(passed);
        moving |= relight(passed);
        if (moving) moved = now;
        if (rough && now - moved > 0.2) redraw = true;
        drawChanges(moving);
        adapting = adaptExposure(passed);
        if (retone) present();
        if (s.spin > 0 && spun >= s.spin) {
            std::printf("%.1f pictures a second of %d x %d\n", spunPictures / spun, s.camera.width,
                        s.camera.height);
            glfwSetWindowShouldClose(window, 1);
        }
    }
}

} // namespace odraz::radiosity
