// Workers on POSIX threads and futexes.
#include "host/threads.h"

#include "host/library.h"
#include "host/linux/sys.h"
#include "host/work.h"

#include <pthread.h>

namespace odraz {

namespace {

#define ODRAZ_PTHREAD(F) F(pthread_create)
struct Pthread {
    ODRAZ_PTHREAD(ODRAZ_MEMBER)
};

// glibc before 2.34 has a separate library for threads; later versions map its name to libc.
const char *loadPthread(Pthread &p) {
    return loadFunctions("libpthread.so.0", ODRAZ_PTHREAD(ODRAZ_NAME), (void **)&p);
}

struct ThreadPool : Work {
    int round; // counts rounds; threads sleep on it
};

void sleepWhile(int *word, int value) { sys::call(sys::kFutex, (long)word, 128 /* WAIT | PRIVATE */, value); }
void wake(int *word, int count) { sys::call(sys::kFutex, (long)word, 129 /* WAKE | PRIVATE */, count); }

[[gnu::force_align_arg_pointer]] void *threadMain(void *context) {
    ThreadPool &pool = *(ThreadPool *)context;
    int worker = pool.newWorker();
    for (int seen = 0;;) {
        int round;
        while ((round = __atomic_load_n(&pool.round, __ATOMIC_ACQUIRE)) == seen)
            sleepWhile(&pool.round, seen);
        seen = round;
        pool.runPieces(worker);
        if (pool.endTurn()) wake(&pool.busy, 1);
    }
}

void run(Workers &workers, int count, int size, void (*body)(const void *, int, int, int),
         const void *context) {
    ThreadPool &pool = *(ThreadPool *)workers.host;
    pool.begin(workers, count, size, body, context);
    __atomic_add_fetch(&pool.round, 1, __ATOMIC_RELEASE);
    wake(&pool.round, workers.count);
    pool.runPieces(0);
    int left;
    while ((left = __atomic_load_n(&pool.busy, __ATOMIC_ACQUIRE)) > 0) sleepWhile(&pool.busy, left);
}

ThreadPool thePool; // belongs to the host, not to the engine: one process has one set of threads

} // namespace

int cpuCount() {
    // Room for 8,192 processors, the most that Linux can be built for: the kernel refuses a shorter mask
    uint64_t mask[128];
    long bytes = sys::call(sys::kGetAffinity, 0, sizeof mask, (long)mask);
    int count = 0;
    for (long i = 0; i < bytes / 8; ++i)
        for (uint64_t m = mask[i]; m; m &= m - 1) ++count;
    return count ? count : 1;
}

const char kMoreThreads[] = "raise the limit on processes (ulimit -u)";

const char *startThread(void *(*body)(void *), void *context) {
    Pthread p;
    if (const char *missing = loadPthread(p)) return missing;
    pthread_t thread;
    return p.pthread_create(&thread, nullptr, body, context) ? "room for another thread" : nullptr;
}

const char *startWorkers(Workers &workers, int count, const int *abort) {
    workers = {count < kMaxWorkers ? count : kMaxWorkers, run, abort, &thePool};
    for (int i = 1; i < workers.count; ++i)
        if (const char *missing = startThread(threadMain, &thePool)) return missing;
    return nullptr;
}

} // namespace odraz
