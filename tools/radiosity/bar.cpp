#include "tools/radiosity/bar.h"

#include <cstdio>
#include <ctime>
#include <unistd.h>

namespace odraz {

static double now() {
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

Bar::Bar() : terminal(isatty(STDERR_FILENO)) {}

void Bar::show(const char *name, float done, float residual) {
    if (!terminal) return;
    if (name != step) step = name, began = now();
    char bar[31] = {}, rest[60] = "";
    for (int i = 0; i < 30; ++i) bar[i] = (float)i < done * 30 ? '#' : '.';
    if (residual >= 0) std::snprintf(rest, sizeof rest, ", residual %.1e", (double)residual);
    double left = done > 0.02f ? (now() - began) * (1 / (double)done - 1) : -1;
    std::fprintf(stderr, "\r\033[K%-13s [%s] %3.0f %%%s", name, bar, (double)done * 100, rest);
    if (left >= 0) std::fprintf(stderr, ", %.0f s left", left);
    std::fflush(stderr);
}

void Bar::clear() {
    if (terminal && step) std::fputs("\r\033[K", stderr);
    step = nullptr;
}

} // namespace odraz
