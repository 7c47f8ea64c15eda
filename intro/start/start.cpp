// Checks the processor. It runs first and on any x86-64, because the film's own code needs AVX2.
#include "host/cpu.h"
#include "host/process.h"
#include "start/early.h"

int odrazRun(int argc, char **argv, int closedDescriptors);

int odrazMain(int argc, char **argv) {
    int closed = odraz::prepareDescriptors() | odraz::theEarly.closedDescriptors;
    if (!odraz::cpuSuffices())
        return odraz::showError(
            "this film needs a processor with AVX2 and FMA (x86-64-v3: Intel since 2013, AMD since 2015)");
    return odrazRun(argc, argv, closed);
}
