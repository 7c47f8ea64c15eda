// Work that several threads share, piece by piece. How threads wait depends on the system.
#pragma once

#include "base/parallel.h"

namespace odraz {

// In its turn a worker runs pieces until none is left, so a quick worker runs more of them.
struct Work {
    void (*body)(const void *, int, int, int);
    const void *context;
    const int *abort;
    int count, size; // number of items, and of items in a piece
    int next;        // first item that no worker has taken yet
    int busy;        // turns that have not ended, not counting the caller's
    int lastWorker;  // number of the last worker

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

    int newWorker() { return __atomic_add_fetch(&lastWorker, 1, __ATOMIC_RELAXED); }

    void runPieces(int worker) {
        while (!__atomic_load_n(abort, __ATOMIC_RELAXED)) {
            int first = __atomic_fetch_add(&next, size, __ATOMIC_RELAXED), end = first + size;
            if (first >= count) return;
            body(context, first, end < count ? end : count, worker);
        }
    }

    // Ends a turn; returns true for the last one.
    bool endTurn() { return __atomic_sub_fetch(&busy, 1, __ATOMIC_ACQ_REL) == 0; }
};

} // namespace odraz
