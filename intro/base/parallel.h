// Parallel-for over independent pieces of work. The host makes the Workers; the engine only uses them. Any
// worker may run any piece, in any order, so no piece may write what another one reads.
#pragma once

namespace odraz {

inline constexpr int kMaxWorkers = 64;

struct Workers {
    int count; // number of threads, including the caller's; 1 .. kMaxWorkers
    // Runs body(context, first, end, worker) for [0, count) in pieces of `size`, and returns when all are
    // done. After an abort the remaining pieces are skipped
    void (*run)(Workers &, int count, int size, void (*body)(const void *, int first, int end, int worker),
                const void *context);
    const int *abort; // becomes non-zero when the viewer leaves; the result must not be used then
    void *host;       // for the host's own use

    bool aborted() const { return __atomic_load_n(abort, __ATOMIC_RELAXED) != 0; }
};

// Calls f(piece, worker) for every piece in [0, pieces).
template <class F> void parallelFor(Workers &workers, int pieces, const F &f) {
    auto body = [](const void *f, int piece, int, int worker) { (*(const F *)f)(piece, worker); };
    workers.run(workers, pieces, 1, body, &f);
}

// Calls f(first, end, worker) for [0, count) in pieces of `size`.
template <class F> void parallelRanges(Workers &workers, int count, int size, const F &f) {
    auto body = [](const void *f, int first, int end, int worker) { (*(const F *)f)(first, end, worker); };
    workers.run(workers, count, size, body, &f);
}

// Workers of one thread, for tests and tools.
inline Workers serialWorkers() {
    static const int never = 0;
    return {
        1,
        [](Workers &w, int count, int size, void (*body)(const void *, int, int, int), const void *context) {
            for (int i = 0; i < count && !w.aborted(); i += size)
                body(context, i, i + size < count ? i + size : count, 0);
        },
        &never, nullptr};
}

} // namespace odraz
