#include "tools/radiosity/solve/terminal.h"

#include <cstdio>

namespace odraz::radiosity {

static int *theStop; // a signal handler has no parameter for it

void stopAt(int &stop, const std::vector<int> &signals) {
    theStop = &stop;
    struct sigaction action = {};
    action.sa_handler = [](int) { __atomic_store_n(theStop, 1, __ATOMIC_RELAXED); };
    action.sa_flags = (int)SA_RESETHAND;
    for (int signal : signals) sigaction(signal, &action, nullptr);
}

void printNotes(const std::vector<std::string> &notes) {
    for (const std::string &note : notes) std::fprintf(stderr, "radiosity: %s\n", note.c_str());
}

} // namespace odraz::radiosity
