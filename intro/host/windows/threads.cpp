#include "host/threads.h"

#include "host/process.h"
#include "host/windows/windows.h"
#include "host/work.h"

namespace odraz {

using namespace windows;

namespace {

constexpr uint32_t kForever = ~0u;

// A job has as many turns, besides the caller's, as there are other workers. A quick worker may take more
// than one turn, and then finds nothing left to do.
struct Pool : Work {
    HANDLE turns, allDone;
};

void *threadMain(void *context) {
    Pool &pool = *(Pool *)context;
    int worker = pool.newWorker();
    for (;;) {
        WaitForSingleObject(pool.turns, kForever);
        pool.take(worker);
        if (pool.done()) ReleaseSemaphore(pool.allDone, 1, nullptr);
    }
}

void run(Workers &workers, int count, int size, void (*body)(const void *, int, int, int),
         const void *context) {
    Pool &pool = *(Pool *)workers.host;
    int turns = workers.count - 1;
    pool.begin(workers, count, size, body, context);
    if (turns) ReleaseSemaphore(pool.turns, turns, nullptr);
    pool.take(0);
    if (turns) WaitForSingleObject(pool.allDone, kForever);
}

Pool thePool; // belongs to the host, not to the engine: one process has one set of threads

struct Start {
    void *(*body)(void *);
    void *context;
};

} // namespace

// Windows starts threads here, in its own convention: rcx points to the Start. The function does not return,
// so it need not preserve registers. Libraries may have changed how a new thread rounds floats: that is set
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
    return count ? count : kMaxWorkers; // 0 if the process uses more than one group of 64
}

static const char kNoRoom[] = "room for another thread";
const char kMoreThreads[] = "end other programs";

const char *startThread(void *(*body)(void *), void *context) {
    Start *start = (Start *)takeMemory(sizeof(Start)); // a page, for as long as the process lives
    if (!start) return kNoRoom;
    *start = {body, context};
    HANDLE thread = CreateThread(nullptr, 0, (void *)odrazThread, start, 0, nullptr);
    return thread ? nullptr : kNoRoom;
}

const char *startWorkers(Workers &workers, int count, const int *abort) {
    workers = {count < kMaxWorkers ? count : kMaxWorkers, run, abort, &thePool};
    thePool.turns = CreateSemaphoreA(nullptr, 0, kMaxWorkers, nullptr);
    thePool.allDone = CreateSemaphoreA(nullptr, 0, 1, nullptr);
    if (!thePool.turns || !thePool.allDone) return kNoRoom;
    for (int i = 1; i < workers.count; ++i)
        if (const char *missing = startThread(threadMain, &thePool)) return missing;
    return nullptr;
}

} // namespace odraz
