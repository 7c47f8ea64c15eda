// The shipped program: look at the machine, read the options, play or dump.
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

// What both ways to show the film need.
struct Prepared {
    Workers workers;
    IntroSettings settings;
    bool hall;  // some of its scenes play there
    bool music; // it is played with sound
    char processor[49];
    Arena arena;
    Intro *intro;
};

// Opens the window, if it is not open yet; returns an exit status. Without --size, pictures are as large as
// the window, up to the largest that can be scaled up.
int openScreen(Options &o) {
    FilmWindow &window = theEarly.window;
    if (!theEarly.opened) {
        Quiet libraries;
        if (const char *wrong = openWindow(window, !o.window, o.width, o.height, &theEarly.viewerLeft))
            return showError(wrong);
    }
    if (o.sized) return 0;
    Area area = areaOf(window, o.width, o.height);
    int width = clamp(area.width, 16, kMostEnlarged);
    o.height = max(area.height * width / max(area.width, 1), 9);
    o.width = width;
    return 0;
}

// Starts threads and takes memory; returns an exit status. What a dump lacks is reported to the script that
// runs it, not in a window.
int prepare(const Options &o, Prepared &f) {
    auto report = o.dump ? printError : showError;
    int count = o.threads ? o.threads : cpuCount();
    if (const char *missing = startWorkers(f.workers, count, &theEarly.viewerLeft)) {
        Message m;
        m << "cannot start " << count << " threads without " << missing << ": try --threads 1";
        return report(m.data);
    }
    // In-betweens also need the frames before the first and after the last
    double beside = o.live ? 1 / 60.0 : 0;
    bool any = !o.dump || firstFrame(o.from, o.fps) < firstFrame(o.to, o.fps);
    f.hall = any && needsHall(seconds(o.from) - beside, seconds(o.to) + beside);
    f.music = !o.dump && !o.mute;
    f.settings = {o.width, o.height};
    f.settings.pairs = o.live || !o.dump;
    cpuName(f.processor);
    if (!o.dump) f.settings.bytes = ownSize(), f.settings.machine = f.processor;
    size_t bytes = memoryNeeded(f.settings, f.workers.count, f.hall) + (f.music ? soundMemory() : 0);
    f.arena = {(unsigned char *)takeMemory(bytes), bytes, 0};
    if (f.arena.base) return 0;
    Message m;
    m << "not enough memory: " << (int64_t)(bytes >> 20) << " MB are needed: " << kMoreMemory;
    return report(m.data);
}

int dumpFilm(const Options &o, Prepared &f, bool stdoutClosed) {
    Gl gl;
    if (f.hall) {
        Quiet libraries;
        if (const char *wrong = openHeadlessGl(gl)) return printError(wrong);
    }
    if (const char *wrong = load(f.intro, f.settings, f.arena, f.workers, f.hall ? &gl : nullptr))
        return printError(wrong);
    return dump(*f.intro, o, stdoutClosed);
}

// The window shows how far loading is.
int playFilm(const Options &o, Prepared &f, int64_t began) {
    FilmWindow &window = theEarly.window;
    const char *wrong = load(f.intro, f.settings, f.arena, f.workers, f.hall ? &window.gl : nullptr,
                             {showLoading, &window, theEarly.opened ? kEarlyShare : 0});
    if (viewerLeft()) return 0;
    Sound *sound = f.music ? loadSound(f.arena) : nullptr;
    return wrong ? showError(wrong) : play(*f.intro, sound, o, window, &theEarly.viewerLeft, began);
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

// Compiled for the newer processor; start/start.cpp has checked it.
int odrazRun(int argc, char **argv, int closed) { return run(argc, argv, closed & 2); }
