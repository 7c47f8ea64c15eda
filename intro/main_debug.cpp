// odraz-debug: the film for its makers, in a GLFW window.
//
//   space        pause and go on            left, right   seek a beat (with shift: a bar)
//   W A S D      fly; Q and E down and up   mouse         look around, with the left button held
//   R            back to the scripted camera   C          print the camera as a line for the files of keys
//   K            set a key of the camera's path here (with shift: remove it)
//   Ctrl Z       undo (with shift: redo)      Ctrl S      save what was edited to the files of keys
//   X            write the tracks for an editor of GNU Rocket
//   1 2 3        draft, play, film          ESC           leave
//   TAB          the panel, H: its keys (maker/panel/keys.h)
#include "base/maths.h"
#include "film.h"
#include "host/clock.h"
#include "host/cpu.h"
#include "host/process.h"
#include "host/threads.h"
#include "intro.h"
#include "maker/debug_options.h"
#include "maker/edits.h"
#include "maker/follower.h"
#include "maker/keys/key_file.h"
#include "maker/panel/input.h"
#include "maker/panel/steps.h"
#include "maker/screen.h"
#include "options.h"
#include "play/music.h"
#include "record.h"
#include "timeline/track.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace odraz;
using namespace odraz::maker;

namespace {

enum class Request { SetKey, RemoveKey, Undo, Redo, Save, WriteTracks, Leave };

struct Maker {
    double time = 0;
    bool paused = false, flying = false, sought = false;
    std::set<Request> requests;
    std::string message; // the result of a request, drawn over the picture for a while
    double messageUntil = 0;
    bool warned = false, closes = false;
    CameraKey camera = {};
    int quality = (int)QualityName::Play;
    double mouseX = 0, mouseY = 0;
    std::set<int> chords; // keys that were pressed with Ctrl; Ctrl may be released first
};

Maker theMaker; // global, because GLFW's callbacks use it
Music theMusic;

// Pauses, and lets the maker fly. A flight starts at the scripted camera.
void takeOver(Maker &m) {
    if (!m.flying) m.camera = cameraAt(m.time);
    m.flying = m.paused = true;
}

void printCamera(const Maker &m) {
    KeyNumbers key = numbersOf(m.flying ? m.camera : cameraAt(m.time));
    for (size_t i = 1; i < key.size(); ++i) key[i] = std::round(key[i] * 1000) / 1000;
    std::puts(writtenKey(key, written(std::round(cameraAt(m.time).row))).c_str());
    std::fflush(stdout);
}

void onKey(GLFWwindow *, int key, int, int action, int mods) {
    Maker &m = theMaker;
    if (action == GLFW_REPEAT && key != GLFW_KEY_LEFT && key != GLFW_KEY_RIGHT) return;
    if (action == GLFW_RELEASE) {
        m.chords.erase(key);
        return;
    }
    double step = (mods & GLFW_MOD_SHIFT ? kRowsPerBar : kRowsPerBar / 4) / kRowsPerSecond;
    auto seek = [&](int direction) {
        m.time = stepBy(m.time, step, direction, duration());
        m.sought = true;
    };
    if (mods & GLFW_MOD_CONTROL) {
        m.chords.insert(key);
        if (key == GLFW_KEY_S) m.requests.insert(Request::Save);
        if (key == GLFW_KEY_Z) m.requests.insert(mods & GLFW_MOD_SHIFT ? Request::Redo : Request::Undo);
        return;
    }
    switch (key) {
    case GLFW_KEY_ESCAPE:
        m.requests.insert(Request::Leave);
        break;
    case GLFW_KEY_SPACE:
        m.paused = !m.paused;
        break;
    case GLFW_KEY_RIGHT:
        seek(1);
        break;
    case GLFW_KEY_LEFT:
        seek(-1);
        break;
    case GLFW_KEY_R:
        m.flying = false;
        break;
    case GLFW_KEY_C:
        printCamera(m);
        break;
    case GLFW_KEY_K:
        m.requests.insert(mods & GLFW_MOD_SHIFT ? Request::RemoveKey : Request::SetKey);
        break;
    case GLFW_KEY_X:
        m.requests.insert(Request::WriteTracks);
        break;
    case GLFW_KEY_1:
    case GLFW_KEY_2:
    case GLFW_KEY_3:
        m.quality = key - GLFW_KEY_1;
        break;
    }
}

void fly(GLFWwindow *window, Maker &m, float seconds, bool mayLook) {
    auto held = [&](int key) {
        return glfwGetKey(window, key) == GLFW_PRESS && !m.chords.count(key) ? 1.f : 0.f;
    };
    float ahead = held(GLFW_KEY_W) - held(GLFW_KEY_S), sideways = held(GLFW_KEY_D) - held(GLFW_KEY_A),
          up = held(GLFW_KEY_E) - held(GLFW_KEY_Q);
    if (held(GLFW_KEY_LEFT_CONTROL) + held(GLFW_KEY_RIGHT_CONTROL) > 0) ahead = sideways = up = 0;
    double x, y;
    glfwGetCursorPos(window, &x, &y);
    float dx = (float)(x - m.mouseX), dy = (float)(y - m.mouseY);
    m.mouseX = x;
    m.mouseY = y;
    bool looking =
        mayLook && glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS && (dx != 0 || dy != 0);
    if (ahead == 0 && sideways == 0 && up == 0 && !looking) return;
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
    float step = 2.5f * seconds;
    m.camera.eye += forward * (ahead * step) + right * (sideways * step) + Vec3{0, up * step, 0};
    m.camera.target = m.camera.eye + forward * distance;
}

// Prints a line to standard error. Returns 1.
int report(const char *line) {
    std::fprintf(stderr, FILM_NAME "-debug: %s\n", line);
    return 1;
}

// Sets the clock by m.time while paused or after a seek, and m.time by the clock otherwise. Loops at the end.
void keepTime(Maker &m) {
    int64_t moment = nanoseconds();
    FilmClock &clock = theMusic.clock;
    clock.watch(moment, processorNanoseconds());
    theMusic.playback.pause(m.paused);
    m.time = std::fmin(m.time, duration()); // the duration may have changed
    if (!m.paused && !m.sought) {
        double time = std::fmin(clock.at(moment), duration());
        m.time = looped(loopBetween(0, duration(), duration()), time);
        if (m.time == time) return;
    }
    clock.start(m.time, moment);
    m.sought = false;
}

// Loads the film while the window shows the progress. Returns null, or what is missing. May set m.closes.
const char *loadFilm(Stage &stage, Screen &screen, uint64_t solvers, Maker &m) {
    std::vector<uint8_t> black((size_t)screen.width * (size_t)screen.height * 4);
    const char *line = needsHall(0, duration()) ? "solving the hall takes some seconds" : "loading";
    auto wait = [&](float share) {
        glfwWaitEventsTimeout(0.03);
        std::fill(black.begin(), black.end(), (uint8_t)0);
        Picture p = {screen.width, screen.height, black.data()};
        drawStatus(p, line, share);
        show(screen, p);
        return !(m.closes =
                     m.closes || m.requests.count(Request::Leave) || glfwWindowShouldClose(screen.window));
    };
    const char *problem = stage.loadFirst(
        screen.gl, solvers, [&](bool on) { screen.useHidden(on); }, wait);
    return m.closes ? nullptr : problem;
}

// Sets the window's title: scene, time, quality and the seconds that the last picture took.
void setTitle(const Screen &s, const Maker &m, double passed, const std::string &more) {
    char title[200];
    std::snprintf(title, sizeof title, FILM_NAME "-debug  %s  %d:%05.2f  row %.1f  %s%s  %.1f ms  %s",
                  sceneName(sceneAt(m.time)), (int)m.time / 60, std::fmod(m.time, 60),
                  m.time * kRowsPerSecond, kQualities[m.quality].name, m.paused ? "  paused" : "",
                  passed * 1e3, more.c_str());
    glfwSetWindowTitle(s.window, title);
}

// Writes the tracks for an editor, but not over a file that somebody else has written. Returns a message.
std::string writeTracks(Edits &edits) try {
    static std::filesystem::file_time_type ours; // when this program wrote it
    const std::string file = FILM_NAME ".rocket";
    if (std::filesystem::exists(file) && std::filesystem::last_write_time(file) != ours)
        return file + " already exists: move it away";
    std::string message = edits.writeDocument(file);
    ours = std::filesystem::last_write_time(file);
    return message;
} catch (const std::runtime_error &e) {
    return e.what();
}

// Carries out the requests of the keys and of the editor.
void edit(Maker &m, Edits &edits, std::string &message) {
    Edits::Requests asked = edits.update(glfwGetTime(), m.time * kRowsPerSecond);
    if (!asked.message.empty()) report(asked.message.c_str());
    if (asked.pause) m.paused = *asked.pause;
    if (asked.row) {
        m.time = *asked.row / kRowsPerSecond;
        m.sought = true;
    }
    if (asked.save) m.requests.insert(Request::WriteTracks);
    auto requested = [&](Request r) { return m.requests.count(r) > 0; };
    if (requested(Request::SetKey) || requested(Request::RemoveKey)) {
        CameraKey view = m.flying ? m.camera : cameraAt(m.time);
        const CameraKey *key = requested(Request::SetKey) ? &view : nullptr;
        m.time = edits.setView(m.time * kRowsPerSecond, key, message) / kRowsPerSecond;
        m.sought = true;
        m.flying = false;
    }
    if (requested(Request::Undo)) message = edits.undo();
    if (requested(Request::Redo)) message = edits.redo();
    if (requested(Request::Save)) report((message = edits.save()).c_str());
    if (requested(Request::WriteTracks)) report((message = writeTracks(edits)).c_str());
    if (!edits.unsaved()) m.warned = false;
    if (requested(Request::Leave)) {
        m.closes |= m.warned || !edits.unsaved();
        if (!m.closes) message = "what you edited is not saved: Ctrl S saves it, ESC again leaves";
        m.warned = true;
    }
    if (!m.requests.empty()) {
        m.message = message;
        m.messageUntil = glfwGetTime() + 4;
    }
    m.requests.clear();
}

void help() {
    std::puts(
        "usage: " FILM_NAME "-debug [--from S] [--size WxH] [--threads N] [--mute] [--rocket [HOST[:PORT]]]\n"
        "       " FILM_NAME "-debug --shown FILE [--from S] [--to S] [--stats] ...\n"
        "       " FILM_NAME "-debug --tracks FILE\n"
        "keys: space, arrows, W A S D Q E, mouse, R, C, K, X, Ctrl Z, Ctrl S, 1 2 3, ESC\n"
        "TAB shows the panel, H all keys.\n"
        "When a source in intro/ is saved, it is compiled, and the new film is shown. The compiler's\n"
        "first error is drawn over the picture.\n"
        "--rocket offers the film's tracks to an editor of GNU Rocket, on localhost if none is named.\n"
        "--tracks writes them as a document that such an editor opens, and ends.\n"
        "--shown plays the film as " FILM_NAME " does, and writes which pictures were shown, and when, for\n"
        "build/judge_play.");
}

// Shows the film in a window until the maker leaves. Returns an exit status.
int run(const Options &o, Stage &stage, Follower &follower, Edits &edits, std::string &message) {
    static const int never = 0;
    Screen screen = {};
    if (const char *missing = open(screen, o.width, o.height)) return report(missing);
    glfwSetKeyCallback(screen.window, onKey);
    stage.settle(o.width, o.height, o.threads ? o.threads : cpuCount(), o.mute);
    Maker &m = theMaker;
    if (const char *problem = loadFilm(stage, screen, follower.solverHash(), m)) return report(problem);
    if (m.closes) return glfwTerminate(), 0;
    if (!stage.problem().empty()) report(stage.problem().c_str());
    Panel panel(o.width, o.height, (double)o.fps.numerator / (double)o.fps.denominator, nanoseconds);
    listen(panel, screen.window);

    m.time = seconds(o.from);
    startMusic(theMusic, stage.sound(), m.time, &never);
    glfwGetCursorPos(screen.window, &m.mouseX, &m.mouseY);
    for (double last = glfwGetTime(); !m.closes;) {
        glfwPollEvents();
        if (glfwWindowShouldClose(screen.window)) m.requests.insert(Request::Leave);
        glfwSetWindowShouldClose(screen.window, GLFW_FALSE);
        double now = glfwGetTime(), passed = now - last;
        last = now;
        if (follower.follow(screen, theMusic.block)) {
            edits.renew();
            panel.renew();
        }
        panel.steer(m.time, m.paused, m.sought);
        edit(m, edits, message);
        keepTime(m);
        fly(screen.window, m, (float)passed, !panel.grabs());
        Picture p =
            panel.picture(stage.intro(), {m.time, kQualities[m.quality], m.flying ? &m.camera : nullptr});
        Picture above = p; // the part above the time line
        if (panel.visible() && panel.timeLine().area.height) above.height = panel.timeLine().area.y;
        follower.drawState(above, exceededLimit(stage.intro()), now < m.messageUntil ? m.message : "");
        show(screen, p);
        follower.wait();
        setTitle(screen, m, passed, message);
    }
    endMusic(theMusic);
    stage.giveUp();
    glfwTerminate();
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    std::string build = std::filesystem::read_symlink("/proc/self/exe").parent_path(), message;
    Options o;
    DebugOptions own;
    Message wrong;
    Stage stage(build + "/live/live.so");
    if (!stage.problem().empty()) return report((stage.problem() + ": build it again").c_str());
    if (std::string line = takeOptions(argc, argv, own); !line.empty()) return report(line.c_str()), 2;
    if (!parseOptions(argc, argv, duration(), o, wrong)) return report(wrong.data), 2;
    if (o.help) return help(), 0;
    if (own.shown) return recordShown(o, own.shown);
    Follower follower(build, stage, [&](const std::string &word, const std::string &line) {
        message = word;
        if (!line.empty()) report(line.c_str());
    });
    Edits edits(stage, follower.showFolder(), own.host, own.port);
    if (own.tracks) try {
            std::puts(edits.writeDocument(own.tracks).c_str());
            return 0;
        } catch (const std::runtime_error &e) {
            return report(e.what());
        }
    return run(o, stage, follower, edits, message);
}
