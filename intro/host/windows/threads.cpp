#include "host/threads.h"

#include "host/process.h"
#include "host/windows/windows.h"
#include "host/work.h"

namespace odraz {

using namespace windows;

namespace {

constexpr uint32_t kForever = ~0u;

// In each call of run(), the caller and every other worker have one turn each. A quick worker may also take
// another one's turn; it finds nothing left to do there.
struct ThreadPool : Work {
    HANDLE turns, allDone;
};

void *threadMain(void *context) {
    ThreadPool &pool = *(ThreadPool *)context;
    int worker = pool.newWorker();
    for (;;) {
        WaitForSingleObject(pool.turns, kForever);
        pool.runPieces(worker);
        if (pool.endTurn()) ReleaseSemaphore(pool.allDone, 1, nullptr);
    }
}

void run(Workers &workers, int count, int size, void (*body)(const void *, int, int, int),
         const void *context) {
    ThreadPool &pool = *(ThreadPool *)workers.host;
    int turns = workers.count - 1;
    pool.begin(workers, count, size, body, context);
    if (turns) ReleaseSemaphore(pool.turns, turns, nullptr);
    pool.runPieces(0);
    if (turns) WaitForSingleObject(pool.allDone, kForever);
}

ThreadPool thePool; // belongs to the host, not to the engine: one process has one set of threads

struct ThreadStart {
    void *(*body)(void *);
    void *context;
};

} // namespace

// Windows starts threads here, in its own convention: rcx points to the ThreadStart. The function does not
// return, so it need not preserve registers. It sets mxcsr as on Linux, because libraries may have changed
// how a new thread rounds floats.
extern "C" void odrazThread();
extern "C" [[gnu::used]] void odrazThreadBody(ThreadStart &start) {
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
    ThreadStart *start = (ThreadStart *)takeMemory(sizeof(ThreadStart)); // a page, which is never freed
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
