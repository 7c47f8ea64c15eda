// A program that checks Windows from inside as the film sees it, with the film's own host and start.
//   probe arguments FILLER | floats | names FOLDER | passing | shown | times
// It prints lines "ok: ..." and "FAILED: ..."; its status is 1 if there is one of the latter.
#include "probe.h"

#include "base/text.h"
#include "host/files.h"
#include "host/process.h"

extern "C" void _start();

using namespace odraz;

namespace probe {

int failures;

void check(const char *what, bool good, int64_t found) {
    Text<300> line;
    line << (good ? "ok: " : "FAILED: ") << what;
    if (!good) {
        ++failures;
        line << ", but " << found;
    }
    line << '\n';
    writeAll(1, line.data, (size_t)line.size);
}

void *function(const char *library, const char *name) {
    void *found = GetProcAddress(LoadLibraryA(library), name);
    if (!found) {
        printError(name);
        endProcess(3);
    }
    return found;
}

void **kernelSlot(const char *wanted) {
    void *found = function("kernel32.dll", wanted);
    for (void *&slot : odrazFunctions.kernel32)
        if (slot == found) return &slot;
    printError(wanted);
    endProcess(3);
}

bool is(const char *a, const char *b) {
    if (!a) return false;
    while (*a && *a == *b) ++a, ++b;
    return *a == *b;
}

} // namespace probe

int odrazMain(int argc, char **argv) {
    using namespace probe;
    // Libraries may have changed the float state, so the start code runs once more, in a bad state
    static bool again;
    if (!again) {
        again = true;
        setMxcsr(kSpoilt);
        _start();
    }
    if (argc == 5 && is(argv[1], "start")) return (int)start(argv[2], argv[3], argv[4]);
    if (argc == 4 && is(argv[1], "console")) return (int)startInConsole(argv[2], argv[3]);
    prepareDescriptors();
    const char *part = argc > 1 ? argv[1] : "";
    check("the stack is aligned for the engine in main", !stackIsOff(), stackIsOff());
    if (theEarly.calls) {
        check("the stub has called what is early", theEarly.calls > 1 && !theEarly.wrong, theEarly.calls);
        check("... with the arguments", theEarly.arguments == argc, theEarly.arguments);
        check("... with the stack aligned for the engine", !theEarly.off, theEarly.off);
    }
    if (is(part, "arguments"))
        arguments();
    else if (is(part, "floats"))
        floats();
    else if (is(part, "names") && argc == 3)
        names(argv[2]);
    else if (is(part, "passing"))
        passing();
    else if (is(part, "shown"))
        shown();
    else if (is(part, "times"))
        times();
    else
        return printError("usage: probe arguments FILLER | floats | names FOLDER | passing | shown | times"),
               2;
    return failures != 0;
}
