// Workers whose threads end with the object. The host (host/threads.h) has one set per process; here a film
// is shown while another is loaded, and each needs its own.
#pragma once

#include "base/parallel.h"
#include "host/work.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace odraz::maker {

class Pool {
public:
    explicit Pool(int count); // threads, including the caller's; 1 .. kMaxWorkers
    ~Pool();
    Pool(const Pool &) = delete;

    Workers &workers() { return all; }
    // Makes work in progress end soon. Its result is useless.
    void abort() { __atomic_store_n(&leave, 1, __ATOMIC_RELAXED); }

private:
    void work();
    void run(int count, int size, void (*body)(const void *, int, int, int), const void *context);

    int leave = 0;
    Workers all;
    Work job = {};
    std::mutex mutex;
    std::condition_variable begins, ends;
    int round = 0;
    bool over = false;
    std::vector<std::thread> threads;
};

} // namespace odraz::maker
