// Work that several threads share and take piece by piece. How they wait for it and for each other depends on
// the system.
#pragma once

#include "base/parallel.h"

namespace odraz {

// A worker takes pieces until none is left, so a quick one takes more.
struct Work {
    void (*body)(const void *, int, int, int);
    const void *context;
    const int *abort;
    int count, size; // of all the work, and of a piece
    int next;        // the first piece not yet taken
    int busy;        // turns not yet done, without the caller's
    int idNext;      // hands out worker numbers

    void begin(const Workers &workers, int all, int piece, void (*f)(const void *, int, int, int),
               const void *data) {
        body = f;
        context = data;
        abort = workers.abort;
        count = all;
        size = piece;
        next = 0;
        busy = workers.count - 1;
    }

    int newWorker() { return __atomic_add_fetch(&idNext, 1, __ATOMIC_RELAXED); }

    void take(int worker) {
        while (!__atomic_load_n(abort, __ATOMIC_RELAXED)) {
            int first = __atomic_fetch_add(&next, size, __ATOMIC_RELAXED), end = first + size;
            if (first >= count) return;
            body(context, first, end < count ? end : count, worker);
        }
    }

    // Ends a turn; true for the last one.
    bool done() { return __atomic_sub_fetch(&busy, 1, __ATOMIC_ACQ_REL) == 0; }
};

} // namespace odraz
