#include "maker/pool.h"

#include <algorithm>

namespace odraz::maker {

Pool::Pool(int count) {
    auto share = [](Workers &w, int all, int size, void (*body)(const void *, int, int, int),
                    const void *context) { ((Pool *)w.host)->run(all, size, body, context); };
    all = {std::clamp(count, 1, kMaxWorkers), share, &leave, this};
    for (int i = 1; i < all.count; ++i) threads.emplace_back([this] { work(); });
}

Pool::~Pool() {
    {
        std::lock_guard lock(mutex);
        over = true;
    }
    begins.notify_all();
    for (std::thread &t : threads) t.join();
}

void Pool::work() {
    int worker = job.newWorker();
    for (int seen = 0;;) {
        {
            std::unique_lock lock(mutex);
            begins.wait(lock, [&] { return over || round != seen; });
            if (over) return;
            seen = round;
        }
        job.runPieces(worker);
        std::lock_guard lock(mutex); // run() must not miss the last notification
        if (job.endTurn()) ends.notify_one();
    }
}

void Pool::run(int count, int size, void (*body)(const void *, int, int, int), const void *context) {
    {
        std::lock_guard lock(mutex);
        job.begin(all, count, size, body, context);
        ++round;
    }
    begins.notify_all();
    job.runPieces(0);
    std::unique_lock lock(mutex);
    ends.wait(lock, [&] { return job.busy == 0; });
}

} // namespace odraz::maker
