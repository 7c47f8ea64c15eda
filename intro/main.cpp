// The shipped program: reads the options, and plays or dumps the film.
#include "base/maths.h"
#include "doctor.h"
#include "host/clock.h"
#include "host/cpu.h"
#include "host/files.h"
#include "host/headless.h"
#include "host/process.h"
#include "host/threads.h"
#include "output/dump.h"
#include "output/wav.h"
#include "play/player.h"
#include "start/answers.h"
#include "start/early.h"

using namespace odraz;

namespace {

// What playing and dumping need.
struct Prepared {
    Workers workers;
    IntroSettings settings;
    bool music; // whether the film is played with sound
    char processor[49];
    Arena arena;
    Intro *intro;
};

// Opens the window, if it is not open yet. Without --size, sets the size of the pictures to the window's, but
// at most to the largest that can be scaled up. Returns an exit status.
int openScreen(Options &o) {
    FilmWindow &window = theEarly.window;
    if (!theEarly.opened) {
        window.stats = o.stats;
        Quiet libraries;
        if (const char *wrong = openWindow(window, !o.window, o.width, o.height, &theEarly.viewerLeft))
            return showError(wrong);
    }
    if (o.sized) return 0;
    Viewport viewport = viewportOf(window, o.width, o.height);
    int width = clamp(viewport.width, 16, kMostEnlarged);
    o.height = max(viewport.height * width / max(viewport.width, 1), 9);
    o.width = width;
    return 0;
}

// Starts threads and allocates memory. Returns an exit status. Errors of a dump are not shown in a window,
// because a script may have started it.
int prepare(const Options &o, Prepared &f) {
    auto report = o.dump ? printError : showError;
    int count = o.threads ? o.threads : cpuCount();
    if (const char *missing = startWorkers(f.workers, count, &theEarly.viewerLeft)) {
        Message m;
        m << "cannot start " << count << " threads without " << missing << ": try --threads 1";
        return report(m.data);
    }
    // In-betweens also need the frames before the first and after the last
    double margin = o.live ? 1 / 60.0 : 0;
    bool any = !o.dump || firstFrame(o.from, o.fps) < firstFrame(o.to, o.fps);
    f.music = !o.dump && !o.mute;
    f.settings = {o.width, o.height};
    f.settings.hall = any && needsHall(seconds(o.from) - margin, seconds(o.to) + margin);
    f.settings.pairs = o.live || !o.dump;
    cpuName(f.processor);
    if (!o.dump) f.settings.bytes = ownSize(), f.settings.machine = f.processor;
    size_t bytes = memoryNeeded(f.settings, f.workers.count) + (f.music ? soundMemory() : 0);
    f.arena = {(unsigned char *)takeMemory(bytes), bytes, 0, false, giveBack};
    if (f.arena.base) return 0;
    Message m;
    m << "not enough memory: " << (int64_t)(bytes >> 20) << " MB are needed: " << kMoreMemory;
    return report(m.data);
}

int dumpFilm(const Options &o, Prepared &f, bool stdoutClosed) {
    Gl gl;
    if (f.settings.hall) {
        Quiet libraries;
        if (const char *wrong = openHeadlessGl(gl)) return printError(wrong);
    }
    if (const char *wrong = load(f.intro, f.settings, f.arena, f.workers, kDrawnHemicubes, &gl))
        return printError(wrong);
    return dump(*f.intro, o, stdoutClosed);
}

// Loads the film while the window shows the progress, and plays it.
int playFilm(const Options &o, Prepared &f, int64_t began) {
    FilmWindow &window = theEarly.window;
    Sound *sound = f.music ? loadSound(f.arena) : nullptr; // before the hall, which may fill the arena
    const char *wrong = load(f.intro, f.settings, f.arena, f.workers, kDrawnHemicubes, &window.gl,
                             {showLoading, &window, theEarly.opened ? kEarlyShare : 0});
    if (viewerLeft()) return 0;
    if (wrong) printError(wrong);
    return play(*f.intro, sound, o, window, &theEarly.viewerLeft, began);
}

int run(int argc, char **argv, bool stdoutClosed) {
    int64_t began = theEarly.began ? theEarly.began : nanoseconds();
    Options o;
    int status;
    if (answered(argc, argv, stdoutClosed, o, status)) return status;
    if (o.doctor) {
        status = printAnswer(o);
        return status ? status : examine();
    }
    if (o.wav) {
        status = writeWav(o, stdoutClosed);
        if (status || !o.dump) return status;
    }
    if (!o.dump && (status = openScreen(o))) return status;
    Prepared film;
    if ((status = prepare(o, film))) return status;
    return o.dump ? dumpFilm(o, film, stdoutClosed) : playFilm(o, film, began);
}

} // namespace

// Compiled for x86-64-v3; start/start.cpp has checked the processor.
int odrazRun(int argc, char **argv, int closed) { return run(argc, argv, closed & 2); }
