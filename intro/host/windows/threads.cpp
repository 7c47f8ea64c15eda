#include "host/threads.h"

#include "host/process.h"
#include "host/windows/windows.h"

namespace odraz {

using namespace windows;

namespace {

constexpr uint32_t kForever = ~0u;

// A piece of work is done by `count - 1` turns beside the caller's. Who is quick takes more than one of them,
// which then finds nothing to do.
struct Pool {
    void (*body)(const void *, int, int, int);
    const void *context;
    const int *abort;
    int count, size; // of all that is to be done, and of a piece
    int next;        // the first that nobody has taken
    int busy;        // turns not yet done
    int idNext;      // hands out worker numbers
    HANDLE turns, done;
};

void work(Pool &pool, int worker) {
    while (!__atomic_load_n(pool.abort, __ATOMIC_RELAXED)) {
        int first = __atomic_fetch_add(&pool.next, pool.size, __ATOMIC_RELAXED), end = first + pool.size;
        if (first >= pool.count) return;
        pool.body(pool.context, first, end < pool.count ? end : pool.count, worker);
    }
}

[[gnu::force_align_arg_pointer]] void *threadMain(void *context) {
    Pool &pool = *(Pool *)context;
    int worker = __atomic_add_fetch(&pool.idNext, 1, __ATOMIC_RELAXED);
    for (;;) {
        WaitForSingleObject(pool.turns, kForever);
        work(pool, worker);
        if (__atomic_sub_fetch(&pool.busy, 1, __ATOMIC_ACQ_REL) == 0) ReleaseSemaphore(pool.done, 1, nullptr);
    }
}

void run(Workers &workers, int count, int size, void (*body)(const void *, int, int, int),
         const void *context) {
    Pool &pool = *(Pool *)workers.host;
    int turns = workers.count - 1;
    pool.body = body;
    pool.context = context;
    pool.abort = workers.abort;
    pool.count = count;
    pool.size = size;
    pool.next = 0;
    pool.busy = turns;
    if (turns) ReleaseSemaphore(pool.turns, turns, nullptr);
    work(pool, 0);
    if (turns) WaitForSingleObject(pool.done, kForever);
}

Pool thePool; // the host's, not the engine's: one process has one set of threads

struct Start {
    void *(*body)(void *);
    void *context;
};

} // namespace

// Where Windows starts a thread, in its convention: rcx is the Start. It does not go back there, so that it
// needs to keep no registers. Libraries may have changed how floats are rounded in a new thread: that is set
// as it is on Linux.
extern "C" void odrazThread();
extern "C" [[gnu::used]] void odrazThreadBody(Start &start) {
    start.body(start.context);
    ExitThread(0);
}
__asm__(".section .text.odrazThread, \"ax\"\n"
        "odrazThread:\n"
        "    push $0x1f80\n"
        "    ldmxcsr (%rsp)\n"
        "    mov %rcx, %rdi\n"
        "    and $-32, %rsp\n"
        "    call odrazThreadBody\n"
        ".text\n");

int cpuCount() {
    uint64_t mask = 0, all;
    GetProcessAffinityMask(kInvalid, &mask, &all);
    int count = 0;
    for (; mask; mask &= mask - 1) ++count;
    return count ? count : kMaxWorkers; // it does not count beyond a group of 64
}

const char kMoreThreads[] = "end other programs";

const char *startThread(void *(*body)(void *), void *context) {
    Start *start = (Start *)takeMemory(sizeof(Start)); // a page, for as long as the process lives
    if (!start) return "room for another thread";
    *start = {body, context};
    HANDLE thread = CreateThread(nullptr, 0, (void *)odrazThread, start, 0, nullptr);
    return thread ? nullptr : "room for another thread";
}

const char *startWorkers(Workers &workers, int count, const int *abort) {
    workers = {count < kMaxWorkers ? count : kMaxWorkers, run, abort, &thePool};
    thePool.turns = CreateSemaphoreA(nullptr, 0, kMaxWorkers, nullptr);
    thePool.done = CreateSemaphoreA(nullptr, 0, 1, nullptr);
    for (int i = 1; i < workers.count; ++i)
        if (const char *missing = startThread(threadMain, &thePool)) return missing;
    return nullptr;
}

} // namespace odraz
