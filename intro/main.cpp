// The shipped program: look at the machine, read the options, play or dump.
#include "doctor.h"
#include "dump.h"
#include "host/clock.h"
#include "host/cpu.h"
#include "host/files.h"
#include "host/headless.h"
#include "host/process.h"
#include "host/threads.h"
#include "play.h"
#include "start/early.h"
#include "version.h"
#include "wav.h"

using namespace odraz;

namespace {

int run(int argc, char **argv, bool stdoutClosed) {
    int64_t began = theEarly.began ? theEarly.began : nanoseconds();
    Options o;
    Message wrong;
    if (!parseOptions(argc, argv, duration(), o, wrong)) {
        complain(wrong.data);
        return 2;
    }
    if (stdoutClosed && (o.help || o.version || o.doctor || o.stats))
        return cannotWrite("standard output", "it is closed");
    if (o.help || o.version || o.doctor) {
        Text<4096> t;
        if (o.help)
            writeHelp(t);
        else
            t << "odraz " ODRAZ_VERSION " " ODRAZ_COMMIT "\n";
        int status = writeOutput("-", t.data, (size_t)t.size);
        return status || !o.doctor ? status : examine();
    }

    if (o.wav) {
        int status = writeWav(o, stdoutClosed);
        if (status || !o.dump) return status;
    }

    // Threads, memory, film. What a dump lacks is told to the script that runs it, not in a window
    auto refuseOrComplain = o.dump ? complain : refuse;
    Workers workers;
    int count = o.threads ? o.threads : cpuCount();
    if (const char *missing = startWorkers(workers, count, &theEarly.viewerLeft)) {
        Message m;
        m << "cannot start " << count << " threads without " << missing << ": try --threads 1";
        return refuseOrComplain(m.data);
    }
    // Frames made from others want those beside the first and the last, too
    double beside = o.live ? 1 / 60.0 : 0;
    bool any = !o.dump || firstFrame(o.from, o.fps) < firstFrame(o.to, o.fps),
         hall = any && needsHall(seconds(o.from) - beside, seconds(o.to) + beside);
    char name[49];
    cpuName(name);
    IntroSettings settings = {o.width, o.height};
    settings.pairs = o.live || !o.dump;
    if (!o.dump) settings.bytes = ownSize(), settings.machine = name;
    bool heard = !o.dump && !o.mute;
    size_t bytes = memoryNeeded(settings, workers.count, hall) + (heard ? soundMemory() : 0);
    Arena arena = {(unsigned char *)takeMemory(bytes), bytes, 0};
    if (!arena.base) {
        Message m;
        m << "not enough memory: " << (int64_t)(bytes >> 20)
          << " MB are needed: " << kMoreMemory;
        return refuseOrComplain(m.data);
    }
    Intro *intro;

    // Play: the window comes first, and shows how far loading is
    if (!o.dump) {
        FilmWindow &window = theEarly.window;
        float loaded = theEarly.opened ? kEarlyShare : 0;
        if (!theEarly.opened) {
            Quiet libraries;
            if (const char *wrong = openWindow(window, !o.window, o.width, o.height, &theEarly.viewerLeft))
                return refuse(wrong);
        }
        const char *wrong = load(intro, settings, arena, workers, hall ? &window.gl : nullptr,
                                 {showLoading, &window, loaded});
        if (viewerLeft()) return 0;
        Sound *sound = heard ? loadSound(arena) : nullptr;
        return wrong ? refuse(wrong) : play(*intro, sound, o, window, &theEarly.viewerLeft, began);
    }
    Gl gl;
    if (hall) {
        Quiet libraries;
        if (const char *wrong = openHeadlessGl(gl)) return complain(wrong);
    }
    if (const char *wrong = load(intro, settings, arena, workers, hall ? &gl : nullptr))
        return complain(wrong);
    return dump(*intro, o, stdoutClosed);
}

} // namespace

// Compiled for the newer processor; start/start.cpp has checked it.
int odrazRun(int argc, char **argv, int closed) { return run(argc, argv, closed & 2); }
