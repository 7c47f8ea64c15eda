// Parallel-for over independent pieces of work. The host makes the Workers; the engine only uses them.
// Which worker runs which piece is not defined, so a piece may write nothing that another one reads.
#pragma once

namespace odraz {

inline constexpr int kMaxWorkers = 64;

struct Workers {
    int count; // threads that work, the caller's among them; 1 .. kMaxWorkers
    // Runs body(context, piece, worker) for every piece in [0, pieces) and returns when all are done.
    void (*run)(Workers &, int pieces, void (*body)(void *, int piece, int worker), void *context);
    const int *abort; // becomes non-zero when the viewer leaves: skip what is left, the result is void
    void *host;       // the host's own

    bool aborted() const { return __atomic_load_n(abort, __ATOMIC_RELAXED) != 0; }
};

// f(piece, worker) for every piece; what is left after an abort is skipped.
template <class F> void parallelFor(Workers &workers, int pieces, F &&f) {
    struct Context {
        F &f;
        Workers &workers;
    } context = {f, workers};
    workers.run(
        workers, pieces,
        [](void *p, int piece, int worker) {
            Context &c = *(Context *)p;
            if (!c.workers.aborted()) c.f(piece, worker);
        },
        &context);
}

// For one thread: tests and tools.
inline Workers serialWorkers() {
    static const int never = 0;
    return {1,
            [](Workers &, int pieces, void (*body)(void *, int, int), void *context) {
                for (int i = 0; i < pieces; ++i) body(context, i, 0);
            },
            &never, nullptr};
}

} // namespace odraz
