#include "tools/radiosity/view/window.h"

#include "host/glfw.h"
#include "host/process.h"
#include "tools/common/text.h"
#include "tools/radiosity/export/camera_options.h"
#include "tools/radiosity/read/upright.h"
#include "trace/picture/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace odraz::radiosity {

static ViewWindow &of(GLFWwindow *window) { return *(ViewWindow *)glfwGetWindowUserPointer(window); }

ViewWindow::ViewWindow(const ViewSettings &settings) : s(settings) {
    Quiet libraries;
    if (const char *missing = openGlfw()) throw std::runtime_error(missing);
    ViewGl gl;
    std::string title = "radiosity: " + s.name;
    if (const char *wrong = openGlfwWindow(window, s.camera.width, s.camera.height, title.c_str(), gl))
        throw std::runtime_error(wrong);
    auto find = [](const char *name) { return (void *)glfwGetProcAddress(name); };
    gl.glClipControl = (PFNGLCLIPCONTROLPROC)find("glClipControl");
    if (const char *missing = fillFunctions(find, ODRAZ_VIEW_GL(ODRAZ_NAME), (void **)&gl.glUniform1i)) {
        glfwTerminate();
        throw std::runtime_error(std::string("OpenGL lacks ") + missing + ": install another driver");
    }
    glfwSwapInterval(s.spin > 0 ? 0 : 1);
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow *w, int key, int, int action, int with) {
        if (action != GLFW_RELEASE) of(w).key(key, with & GLFW_MOD_SHIFT);
    });
    glfwSetScrollCallback(window, [](GLFWwindow *w, double, double notches) {
        float &stops = of(w).s.camera.stops;
        stops = std::clamp(stops + (float)notches * 0.25f, -20.f, 20.f);
    });
    // Handle events in their order, because a whole gesture may happen between two slow pictures
    glfwSetMouseButtonCallback(window, [](GLFWwindow *w, int button, int action, int) {
        if (button == GLFW_MOUSE_BUTTON_LEFT) of(w).looking = action == GLFW_PRESS;
        if (button == GLFW_MOUSE_BUTTON_RIGHT) of(w).turning = action == GLFW_PRESS;
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow *w, double x, double y) { of(w).pointer(x, y); });
    glfwSetInputMode(window, GLFW_STICKY_KEYS, 1);
    glfwSetWindowRefreshCallback(window, [](GLFWwindow *w) { of(w).retone = true; });
    glfwGetCursorPos(window, &mouseX, &mouseY);
    tone.logarithmic = s.camera.logarithmic;
    picture = std::make_unique<ViewPicture>(gl);
}

// Leaves the display's libraries loaded until the process ends, because they leak memory when unloaded.
ViewWindow::~ViewWindow() { glfwDestroyWindow(window); }

void ViewWindow::wake() { glfwPostEmptyEvent(); }

// Every key tone-maps the picture again; some keys also draw the scene again.
void ViewWindow::key(int key, bool shift) {
    retone = true;
    if (room && room->key(key, shift)) return;
    int first = room ? GLFW_KEY_F2 : GLFW_KEY_1; // in a room, digits switch lamps
    if (key >= first && key < first + 4)
        toggle(kViewLayers[key - first].shown);
    else if (key == GLFW_KEY_B)
        toggle(&ViewLayers::backs);
    else if (key == GLFW_KEY_T)
        tone.logarithmic ^= true, s.camera.logarithmic = tone.logarithmic;
    else if (key == GLFW_KEY_R)
        s.camera.eye = start.eye, s.camera.target = start.target, redraw = true;
    else if (key == GLFW_KEY_C)
        std::printf("%s%s\n", cameraLine(s.camera).c_str(), room ? room->commandOptions().c_str() : ""),
            std::fflush(stdout);
    else if (key == GLFW_KEY_H || key == GLFW_KEY_F1)
        help ^= true;
    else if (key == GLFW_KEY_ESCAPE)
        glfwSetWindowShouldClose(window, 1);
}

void ViewWindow::toggle(bool ViewLayers::*layer) {
    s.layers.*layer ^= true;
    if (layer == &ViewLayers::hemicube)
        pointerX = -1, patch = 0;
    else
        redraw |= layer != &ViewLayers::patches || s.layers.wireframe;
}

void ViewWindow::pointer(double x, double y) {
    if (looking) lookX += (float)(x - mouseX), lookY += (float)(y - mouseY);
    if (turning) turnX += (float)(x - mouseX), turnY += (float)(y - mouseY);
    mouseX = x, mouseY = y;
}

void ViewWindow::show(std::shared_ptr<const ViewMesh> mesh, const std::vector<Rgb> &light,
                      const RenderSettings &camera) {
    size = mesh->size;
    if (!s.placed) s.camera.eye = camera.eye, s.camera.target = camera.target;
    if (!s.placed && !s.screenshot.empty()) std::printf("%s\n", placeOptions(s.camera).c_str());
    s.placed = true;
    start = s.camera;
    picture->load(std::move(mesh));
    picture->relight(light);
    redraw = true;
    patch = 0;
    ++pictures;
}

void ViewWindow::show(RelitRoom &shown, const RenderSettings &camera) {
    room = &shown;
    // Compute the light for the camera's position, on which gloss depends
    show(room->mesh(), *room->light(s.placed ? s.camera.eye : camera.eye), camera);
}

// Turns the sky by a third of a degree per pixel. Returns whether the light changed.
bool ViewWindow::relight(float seconds) {
    if (!room) return false;
    float x = std::exchange(turnX, 0.f), y = std::exchange(turnY, 0.f);
    if (x != 0 || y != 0) room->turn((double)x / 3, (double)-y / 3);
    if (s.spin > 0 && measured) {
        room->turn(360 * (double)seconds / s.spin, 0);
        spun += (double)seconds, ++spunPictures;
    }
    const std::vector<Rgb> *light = room->light(s.camera.eye);
    if (light) picture->relight(*light), redraw = true, ++pictures;
    return light;
}

void ViewWindow::takeNews(BackgroundSolve &solver) {
    SolveNews news = solver.takeNews();
    if (news.mesh)
        show(news.mesh, *news.light, news.camera);
    else if (news.light)
        picture->relight(*news.light), redraw = true, ++pictures;
    retone |= news.done && !solved; // for a screenshot
    solved = news.done;
}

// Moves the camera by keys, and turns it about the eye by the mouse. Returns whether it moved.
bool ViewWindow::fly(float seconds) {
    auto held = [&](int key) { return glfwGetKey(window, key) == GLFW_PRESS ? 1.f : 0.f; };
    float ahead = held(GLFW_KEY_W) - held(GLFW_KEY_S), sideways = held(GLFW_KEY_D) - held(GLFW_KEY_A),
          rise = held(GLFW_KEY_E) - held(GLFW_KEY_Q);
    float dx = std::exchange(lookX, 0.f), dy = std::exchange(lookY, 0.f);
    if ((ahead == 0 && sideways == 0 && rise == 0 && dx == 0 && dy == 0) || size == 0) return false;
    RenderSettings &c = s.camera;
    Vec3 eye = upright(c.eye, c.upIsZ), to = upright(c.target, c.upIsZ) - eye;
    float distance = std::max(length(to), size * 1e-3f), yaw = std::atan2(to.x, -to.z),
          pitch = std::asin(std::clamp(to.y / distance, -1.f, 1.f));
    yaw += dx * 0.004f;
    if (dy != 0) pitch = std::clamp(pitch - dy * 0.004f, -1.5f, 1.5f);
    Vec3 forward = {std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw)};
    Vec3 right = {std::cos(yaw), 0, std::sin(yaw)};
    float step = 0.15f * size * std::min(seconds, 0.2f) * (held(GLFW_KEY_LEFT_SHIFT) != 0 ? 5.f : 1.f);
    eye += forward * (ahead * step) + right * (sideways * step) + Vec3{0, rise * step, 0};
    c.eye = asInModel(eye, c.upIsZ);
    c.target = asInModel(eye + forward * distance, c.upIsZ);
    return redraw = true;
}

// --- The loop: draws after each change until the window closes ---

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
