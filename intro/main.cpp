// The shipped program: look at the machine, read the options, play or dump.
#include "dump.h"
#include "host/files.h"
#include "host/machine.h"
#include "host/threads.h"
#include "play.h"
#include "version.h"

using namespace odraz;

namespace {

Intro theIntro;
int theViewerLeft;

int say(const char *text, int size) {
    const char *wrong = writeAll(1, text, (size_t)size);
    return wrong ? cannotWrite("standard output", wrong) : 0;
}

int run(int argc, char **argv, bool stdoutClosed) {
    Options o;
    Message wrong;
    if (!parseOptions(argc, argv, duration(), o, wrong)) {
        complain(wrong.data);
        return 2;
    }
    if (o.help || o.version) {
        if (stdoutClosed) return cannotWrite("standard output", "it is closed");
        Text<4096> t;
        t << (o.help ? kHelp : "odraz " ODRAZ_VERSION " " ODRAZ_COMMIT "\n");
        return say(t.data, t.size);
    }

    // Threads, memory, film. What a dump lacks is told to the script that runs it, not in a window
    auto refuseOrComplain = o.dump ? complain : refuse;
    Workers workers;
    int count = o.threads ? o.threads : cpuCount();
    if (const char *missing = startWorkers(workers, count, &theViewerLeft)) {
        Message m;
        m << "cannot start " << count << " threads without " << missing << ": try --threads 1";
        return refuseOrComplain(m.data);
    }
    size_t bytes = memoryNeeded(o.width, o.height, workers.count);
    Arena arena = {(unsigned char *)takeMemory(bytes), bytes, 0};
    char name[49];
    cpuName(name);
    Facts facts = o.dump ? Facts{} : Facts{ownSize(), name};
    if (!arena.base || !load(theIntro, arena, workers, o.width, o.height, facts, nullptr, nullptr)) {
        Message m;
        m << "not enough memory: " << (int64_t)(bytes >> 20) << " MB are needed; try a smaller --size";
        return refuseOrComplain(m.data);
    }
    return o.dump ? dump(theIntro, o, stdoutClosed) : play(theIntro, o, &theViewerLeft);
}

} // namespace

// Compiled for the newer processor; host/start.cpp has checked it.
int odrazRun(int argc, char **argv, int closed) { return run(argc, argv, closed & 2); }
