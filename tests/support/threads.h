// Workers on threads of the standard library. Tests of the engine alone use them in place of the host's pool.
#pragma once

#include "base/maths.h"
#include "base/parallel.h"

#include <atomic>

namespace odraz {

struct Threads {
    Workers workers;
    int abort = 0;
    explicit Threads(int count) : workers(serialWorkers()) {
        workers.abort = &abort;
        if (count == 1) return;
        workers = {count,
                   [](Workers &w, int count, int size, void (*body)(const void *, int, int, int),
                      const void *context) {
                       std::atomic<int> next{0};
                       std::vector<std::thread> all;
                       for (int t = 0; t < w.count; ++t)
                           all.emplace_back([&, t] {
                               for (int i; (i = next.fetch_add(size)) < count && !w.aborted();)
                                   body(context, i, min(i + size, count), t);
                           });
                       for (std::thread &t : all) t.join();
                   },
                   &abort, nullptr};
    }
};

} // namespace odraz
