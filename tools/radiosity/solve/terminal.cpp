#include "tools/radiosity/solve/terminal.h"

#include "tools/common/clock.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace odraz::radiosity {

const int *stopAt(const std::vector<int> &signals) {
    static int stop; // a signal handler has no parameter for it
    struct sigaction action = {};
    action.sa_handler = [](int) { __atomic_store_n(&stop, 1, __ATOMIC_RELAXED); };
    action.sa_flags = (int)SA_RESETHAND;
    for (int signal : signals) sigaction(signal, &action, nullptr);
    return &stop;
}

void printNotes(const std::vector<std::string> &notes) {
    for (const std::string &note : notes) std::fprintf(stderr, "radiosity: %s\n", note.c_str());
}

ProgressBar::ProgressBar(bool lines)
    : terminal(isatty(STDERR_FILENO)), lines(lines && !terminal), start(common::wallSeconds()) {}

void ProgressBar::show(const char *name, float done, float residual) {
    if (!terminal && !lines) return;
    double time = common::wallSeconds();
    bool isNew = name != step;
    if (isNew) step = name, began = time, first = done, ended = false;
    char rest[90] = "";
    int at = 0;
    if (residual >= 0) at = std::snprintf(rest, sizeof rest, ", residual %.1e", (double)residual);
    if (done > first + 0.02f && done < 1)
        std::snprintf(rest + at, sizeof rest - (size_t)at, ", %.0f s left",
                      (time - began) * (double)((1 - done) / (done - first)));
    if (terminal) {
        char bar[31] = {};
        for (int i = 0; i < 30; ++i) bar[i] = (float)i < done * 30 ? '#' : '.';
        std::fprintf(stderr, "\r\033[K%-13s [%s] %3.0f %%%s", name, bar, (double)done * 100, rest);
    } else if (isNew || (done >= 1 && !ended) || time - lineTime > std::max(1., (time - start) / 20)) {
        lineTime = time;
        ended = done >= 1;
        std::fprintf(stderr, "progress: %s %.0f %%%s\n", name, std::floor((double)done * 100), rest);
    }
    std::fflush(stderr);
}

void ProgressBar::clear() {
    if (terminal && step) std::fputs("\r\033[K", stderr);
    step = nullptr;
}

} // namespace odraz::radiosity
