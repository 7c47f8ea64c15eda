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
#include "maker/rebuilder.h"
#include "maker/stage.h"
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
#include <filesystem>
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

namespace {

// The window, and a picture in it.
struct Screen {
    GLFWwindow *window, *hidden; // the latter's context is for what is loaded in the background
    Gl gl;
    int width, height;
    GLuint texture, framebuffer;
};

const char *open(Screen &s, int width, int height) {
    if (!glfwInit()) return "no display: set DISPLAY";
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    s.window = glfwCreateWindow(width, height, FILM_NAME "-debug", nullptr, nullptr);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    s.hidden = s.window ? glfwCreateWindow(16, 16, "", nullptr, nullptr) : nullptr;
    if (!s.hidden) return "no OpenGL 3.3 on this display";
    glfwMakeContextCurrent(s.window);
    glfwSetKeyCallback(s.window, onKey);
    s.width = width;
    s.height = height;
    if (findGl([](const char *name) { return (void *)glfwGetProcAddress(name); }, s.gl))
        return "no OpenGL 3.3 on this display";
    return nullptr;
}

void prepare(Screen &s) {
    s.gl.glBindFramebuffer(GL_FRAMEBUFFER, 0);
    s.gl.glGenTextures(1, &s.texture);
    s.gl.glBindTexture(GL_TEXTURE_2D, s.texture);
    s.gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, s.width, s.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    s.gl.glGenFramebuffers(1, &s.framebuffer);
    s.gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, s.framebuffer);
    s.gl.glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, s.texture, 0);
}

void show(Screen &s, const Picture &p) {
    int w, h;
    glfwGetFramebufferSize(s.window, &w, &h);
    s.gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, s.width, s.height, GL_RGBA, GL_UNSIGNED_BYTE, p.rgba);
    s.gl.glBlitFramebuffer(0, 0, s.width, s.height, 0, h, w, 0, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glfwSwapBuffers(s.window);
}

// When paused or sought, the clock follows us; otherwise we follow it.
void keepTime(Maker &m) {
    int64_t moment = nanoseconds();
    FilmClock &clock = theMusic.clock;
    clock.watch(moment, processorNanoseconds());
    theMusic.playback.pause(m.paused);
    m.time = std::fmin(m.time, duration()); // which may have changed
    if (m.paused || m.sought)
        clock.start(m.time, moment);
    else
        m.time = std::fmin(clock.at(moment), duration());
    m.sought = false;
}

// Where and how fast we are.
void tell(const Screen &s, const Maker &m, double passed, const std::string &more) {
    char title[200];
    std::snprintf(title, sizeof title, FILM_NAME "-debug  %s  %d:%05.2f  row %.1f  %s%s  %.1f ms  %s",
                  sceneName(sceneAt(m.time)), (int)m.time / 60, std::fmod(m.time, 60),
                  m.time * kRowsPerSecond, kQualities[m.quality].name, m.paused ? "  paused" : "",
                  passed * 1e3, more.c_str());
    glfwSetWindowTitle(s.window, title);
}

// Follows the sources: what was saved is built, and what was built is shown.
struct Follower {
    Rebuilder rebuilder;
    Stage &stage;
    std::string news; // for the title
    bool failed = false;

    void follow(Screen &screen) {
        Rebuilder::News what = rebuilder.poll(glfwGetTime());
        bool built = what == Rebuilder::News::Built;
        if (what == Rebuilder::News::Building) news = "building";
        failed = what == Rebuilder::News::Failed || (failed && !built);
        if (what == Rebuilder::News::Failed) say("does not compile", rebuilder.error());
        if (built) {
            stage.change(screen.gl, rebuilder.solverHash(), theMusic.block,
                         [&](bool on) { glfwMakeContextCurrent(on ? screen.hidden : nullptr); });
            if (!stage.told().empty()) say("loading", stage.told());
        }
        if (stage.poll(theMusic.block) || (built && stage.told().empty())) {
            char line[80];
            std::snprintf(line, sizeof line, "new since %.1f s after it was saved",
                          glfwGetTime() - rebuilder.saved());
            say(line, line);
        }
    }
    void say(const char *inTitle, const std::string &line) {
        news = inTitle;
        fail(line.c_str());
    }
    // What there is to tell, over the picture. `limit`: a constant that is too small, or null.
    void write(const Picture &p, const char *limit) const {
        std::string line = failed ? rebuilder.error() : stage.told();
        if (line.empty() && limit)
            line = std::string("this scene outgrew a limit; raise in scene.h: ") + limit;
        if (!line.empty()) liveInUse()->write(p, line.c_str(), stage.loaded());
    }
    // The compiler needs the processors: until it is done, few pictures are made.
    void wait() const {
        if (rebuilder.building()) glfwWaitEventsTimeout(0.2);
    }
};

} // namespace

int main(int argc, char **argv) {
    const char *shown = takeShown(argc, argv);
    std::string build = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    Options o;
    Message wrong;
    Stage stage(build + "/live/live.so");
    if (!stage.problem().empty()) return fail((stage.problem() + ": build it anew").c_str());
    if (!parseOptions(argc, argv, duration(), o, wrong)) {
        fail(wrong.data);
        return 2;
    }
    if (o.help) {
        std::puts("usage: " FILM_NAME "-debug [--from S] [--size WxH] [--threads N] [--mute]\n"
                  "       " FILM_NAME "-debug --shown FILE [--from S] [--to S] [--stats] ...\n"
                  "keys: space, arrows, W A S D Q E, mouse, R, C, 1 2 3, ESC\n"
                  "A source in intro/ that is saved is compiled, and shown as soon as it is; what is wrong\n"
                  "with it stands in the picture.\n"
                  "--shown plays the film as " FILM_NAME
                  " does, and writes which pictures were shown, and when, for\n"
                  "build/seen.");
        return 0;
    }
    if (shown) return recordShown(o, shown);
    static const int never = 0;
    Screen screen = {};
    if (const char *missing = open(screen, o.width, o.height)) return fail(missing);
    Follower follower = {Rebuilder(build), stage, "", false};
    if (!follower.rebuilder.problem().empty()) fail(follower.rebuilder.problem().c_str());
    stage.settle(o.width, o.height, o.threads ? o.threads : cpuCount(), o.mute);
    if (const char *problem = stage.loadFirst(screen.gl, follower.rebuilder.solverHash()))
        return fail(problem);
    prepare(screen);

    Maker &m = theMaker;
    m.time = seconds(o.from);
    startMusic(theMusic, stage.sound(), m.time, &never);
    glfwGetCursorPos(screen.window, &m.mouseX, &m.mouseY);
    for (double last = glfwGetTime(); !glfwWindowShouldClose(screen.window);) {
        glfwPollEvents();
        double now = glfwGetTime(), passed = now - last;
        last = now;
        follower.follow(screen);
        keepTime(m);
        fly(screen.window, m, (float)passed);
        Picture p = picture(stage.intro(), 0, m.time, kQualities[m.quality], m.flying ? &m.camera : nullptr);
        follower.write(p, outgrown(stage.intro()));
        show(screen, p);
        follower.wait();
        tell(screen, m, passed, follower.news);
    }
    endMusic(theMusic);
    stage.giveUp();
    glfwTerminate();
    return 0;
}
