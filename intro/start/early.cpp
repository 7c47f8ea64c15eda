#include "start/early.h"

#include "host/clock.h"
#include "host/cpu.h"
#include "host/process.h"
#include "start/answers.h"

namespace odraz {

Early theEarly;

namespace {

// Answers options that need no film, and opens the window if the film will be played.
void open(int argc, char **argv) {
    if (!cpuSuffices()) return; // main reports it
    Options o;
    int status;
    if (answered(argc, argv, theEarly.closedDescriptors & 2, o, status)) endProcess(status);
    if (o.doctor || o.dump || o.wav) return;
    Quiet libraries;
    theEarly.window.stats = o.stats;
    if (const char *line = openWindow(theEarly.window, !o.window, o.width, o.height, &theEarly.viewerLeft))
        endProcess(showError(line));
    theEarly.opened = true;
}

} // namespace

} // namespace odraz

extern "C" void odrazEarly(void **stack, uint32_t done, uint32_t size) {
    using namespace odraz;
    if (!theEarly.began) {
        theEarly.began = nanoseconds();
        theEarly.closedDescriptors = prepareDescriptors();
        open((int)(long)stack[0], (char **)(stack + 1));
    }
    if (viewerLeft()) endProcess(0);
    if (theEarly.opened) showLoading(kEarlyShare * (float)done / (float)size, &theEarly.window);
}
