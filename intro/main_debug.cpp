// odraz-debug: the film for its makers, in a GLFW window.
//
//   space        pause and go on            left, right   seek a beat (with shift: a bar)
//   W A S D      fly; Q and E down and up   mouse         look around, with the left button held
//   R            back to the scripted camera   C          print the camera as a line for the show's tables
//   1 2 3        draft, play, film          ESC           leave
#include "base/gl.h"
#include "base/maths.h"
#include "film.h"
#include "host/clock.h"
#include "host/cpu.h"
#include "host/library.h"
#include "host/process.h"
#include "host/threads.h"
#include "intro.h"
#include "options.h"
#include "play/music.h"
#include "record.h"
#include "timeline/track.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace odraz;

namespace {

struct Maker {
    double time = 0;
    bool paused = false, flying = false, sought = false;
    CameraKey camera = {};
    int quality = (int)QualityName::Play;
    double mouseX = 0, mouseY = 0;
};

Maker theMaker; // GLFW's callbacks reach it
Music theMusic;

// The first move away from the script starts at the scripted camera.
void takeOver(Maker &m) {
    if (!m.flying) m.camera = cameraAt(m.time);
    m.flying = m.paused = true;
}

void printCamera(const Maker &m) {
    CameraKey c = m.flying ? m.camera : cameraAt(m.time);
    std::printf("{%.0f, {%.3ff, %.3ff, %.3ff}, {%.3ff, %.3ff, %.3ff}, %.2ff, %.2ff},\n",
                (double)cameraAt(m.time).row, (double)c.eye.x, (double)c.eye.y, (double)c.eye.z,
                (double)c.target.x, (double)c.target.y, (double)c.target.z, (double)c.roll, (double)c.fov);
    std::fflush(stdout);
}

void onKey(GLFWwindow *window, int key, int, int action, int mods) {
    if (action == GLFW_RELEASE) return;
    Maker &m = theMaker;
    double step = (mods & GLFW_MOD_SHIFT ? kRowsPerBar : kRowsPerBar / 4) / kRowsPerSecond;
    switch (key) {
    case GLFW_KEY_ESCAPE:
        glfwSetWindowShouldClose(window, 1);
        break;
    case GLFW_KEY_SPACE:
        m.paused = !m.paused;
        break;
    case GLFW_KEY_RIGHT:
        m.time = std::fmin(m.time + step, duration());
        m.sought = true;
        break;
    case GLFW_KEY_LEFT:
        m.time = std::fmax(m.time - step, 0);
        m.sought = true;
        break;
    case GLFW_KEY_R:
        m.flying = false;
        break;
    case GLFW_KEY_C:
        printCamera(m);
        break;
    case GLFW_KEY_1:
    case GLFW_KEY_2:
    case GLFW_KEY_3:
        m.quality = key - GLFW_KEY_1;
        break;
    }
}

void fly(GLFWwindow *window, Maker &m, float seconds) {
    auto held = [&](int key) { return glfwGetKey(window, key) == GLFW_PRESS ? 1.f : 0.f; };
    float ahead = held(GLFW_KEY_W) - held(GLFW_KEY_S), aside = held(GLFW_KEY_D) - held(GLFW_KEY_A),
          up = held(GLFW_KEY_E) - held(GLFW_KEY_Q);
    double x, y;
    glfwGetCursorPos(window, &x, &y);
    float dx = (float)(x - m.mouseX), dy = (float)(y - m.mouseY);
    m.mouseX = x;
    m.mouseY = y;
    bool looking = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS && (dx != 0 || dy != 0);
    if (ahead == 0 && aside == 0 && up == 0 && !looking) return;
    takeOver(m);

    // Turn about the eye, keeping the distance to the target
    Vec3 to = m.camera.target - m.camera.eye;
    float distance = length(to), yaw = std::atan2(to.x, -to.z),
          pitch = std::asin(clamp(to.y / distance, -1.f, 1.f));
    if (looking) {
        yaw += dx * 0.004f;
        pitch = clamp(pitch - dy * 0.004f, -1.5f, 1.5f);
    }
    Vec3 forward = {std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw)};
    Vec3 right = normalize(cross(forward, Vec3{0, 1, 0}));
    float way = 2.5f * seconds;
    m.camera.eye += forward * (ahead * way) + right * (aside * way) + Vec3{0, up * way, 0};
    m.camera.target = m.camera.eye + forward * distance;
}

int fail(const char *line) {
    std::fprintf(stderr, FILM_NAME "-debug: %s\n", line);
    return 1;
}

// Takes "--shown FILE" out of the words, which the film itself does not know; null: it is not there.
const char *takeShown(int &argc, char **argv) {
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::string(argv[i]) != "--shown") continue;
        const char *file = argv[i + 1];
        argc -= 2;
        std::copy(argv + i + 2, argv + argc + 2, argv + i);
        return file;
    }
    return nullptr;
}

} // namespace

int main(int argc, char **argv) {
    const char *shown = takeShown(argc, argv);
    Options o;
    Message wrong;
    if (!parseOptions(argc, argv, duration(), o, wrong)) {
        fail(wrong.data);
        return 2;
    }
    if (o.help) {
        std::puts(
            "usage: " FILM_NAME "-debug [--from S] [--size WxH] [--threads N] [--mute]\n"
            "       " FILM_NAME "-debug --shown FILE [--from S] [--to S] [--stats] ...\n"
            "keys: space, arrows, W A S D Q E, mouse, R, C, 1 2 3, ESC\n"
            "--shown plays the film as " FILM_NAME " does, and writes which pictures were shown, and when, for\n"
            "build/seen.");
        return 0;
    }
    if (shown) return recordShown(o, shown);
    static const int never = 0;
    Workers workers;
    if (const char *missing = startWorkers(workers, o.threads ? o.threads : cpuCount(), &never))
        return fail(missing);
    if (!glfwInit()) return fail("no display: set DISPLAY");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow *window = glfwCreateWindow(o.width, o.height, FILM_NAME "-debug", nullptr, nullptr);
    if (!window) return fail("no OpenGL 3.3 on this display");
    glfwMakeContextCurrent(window);
    glfwSetKeyCallback(window, onKey);
    Gl gl;
    if (findGl([](const char *name) { return (void *)glfwGetProcAddress(name); }, gl))
        return fail("no OpenGL 3.3 on this display");
    IntroSettings settings = {o.width, o.height};
    size_t bytes = memoryNeeded(settings, workers.count, true) + soundMemory();
    Arena arena = {(unsigned char *)takeMemory(bytes), bytes, 0};
    Intro *intro;
    if (!arena.base) return fail("not enough memory: try a smaller --size");
    if (const char *problem = load(intro, settings, arena, workers, &gl)) return fail(problem);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, 0);
    GLuint texture, framebuffer;
    gl.glGenTextures(1, &texture);
    gl.glBindTexture(GL_TEXTURE_2D, texture);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, o.width, o.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.glGenFramebuffers(1, &framebuffer);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    gl.glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);

    Maker &m = theMaker;
    m.time = seconds(o.from);
    startMusic(theMusic, o.mute ? nullptr : loadSound(arena), m.time, &never);
    glfwGetCursorPos(window, &m.mouseX, &m.mouseY);
    for (double last = glfwGetTime(); !glfwWindowShouldClose(window);) {
        glfwPollEvents();
        double now = glfwGetTime(), passed = now - last;
        last = now;
        // When paused or sought, the clock follows us; otherwise we follow it
        int64_t moment = nanoseconds();
        FilmClock &clock = theMusic.clock;
        clock.watch(moment, processorNanoseconds());
        theMusic.playback.pause(m.paused);
        if (m.paused || m.sought)
            clock.start(m.time, moment);
        else
            m.time = std::fmin(clock.at(moment), duration());
        m.sought = false;
        fly(window, m, (float)passed);
        Picture p = picture(*intro, 0, m.time, kQualities[m.quality], m.flying ? &m.camera : nullptr);
        if (const char *limit = outgrown(*intro))
            return fail(
                (std::string(sceneName(sceneAt(m.time))) + " outgrew a limit; raise in scene.h: " + limit)
                    .c_str());
        int w, h;
        glfwGetFramebufferSize(window, &w, &h);
        gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, o.width, o.height, GL_RGBA, GL_UNSIGNED_BYTE, p.rgba);
        gl.glBlitFramebuffer(0, 0, o.width, o.height, 0, h, w, 0, GL_COLOR_BUFFER_BIT, GL_LINEAR);
        glfwSwapBuffers(window);
        // The overlay: where and how fast we are
        char title[160];
        std::snprintf(title, sizeof title, FILM_NAME "-debug  %s  %d:%05.2f  row %.1f  %s%s  %.1f ms",
                      sceneName(sceneAt(m.time)), (int)m.time / 60, std::fmod(m.time, 60),
                      m.time * kRowsPerSecond, kQualities[m.quality].name, m.paused ? "  paused" : "",
                      passed * 1e3);
        glfwSetWindowTitle(window, title);
    }
    endMusic(theMusic);
    glfwTerminate();
    return 0;
}
