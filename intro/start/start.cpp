// The first thing that runs, on any x86-64: nothing of the film may be touched before the processor is known.
#include "start/early.h"
#include "host/machine.h"

int odrazRun(int argc, char **argv, int closedDescriptors);

int odrazMain(int argc, char **argv) {
    int closed = odraz::guardStandardDescriptors() | odraz::theEarly.closedDescriptors;
    odraz::ignoreBrokenPipes();
    if (!odraz::cpuSuffices())
        return odraz::refuse(
            "this film needs a processor with AVX2 and FMA (x86-64-v3: Intel since 2013, AMD since 2015)");
    return odrazRun(argc, argv, closed);
}
