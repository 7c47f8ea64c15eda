// How floats are rounded and how deep the stack is, in the main thread, in workers, and in another thread;
// and the protection of the program's memory.
#include "probe.h"

#include "host/process.h"
#include "host/threads.h"

using namespace odraz;

namespace probe {

namespace {

struct Found {
    uint32_t mxcsr;
    bool denormals;
    int64_t off;       // misalignment of the stack
    int64_t committed; // bytes of the stack below, up to 2 kFrame
    int deep;          // result of a function with a large frame
    bool done;
};

constexpr int64_t kFrame = 256 << 10;

// 1e-38 * 0.01 is denormal; the product is 0 if denormals are flushed
bool keepsDenormals() {
    volatile float small = 1e-38f, less = 0.01f;
    volatile float product = small * less;
    volatile float denormal = product;
    return product > 0 && denormal * 2 > product;
}

// Touches the far end first, and so skips any guard page
[[gnu::noinline]] int deep() {
    volatile char frame[kFrame];
    frame[0] = 1;
    for (int64_t i = 4096; i < kFrame; i += 4096) frame[i] = frame[i - 4096] + 1;
    return frame[kFrame - 4096];
}

// Consecutive pages with equal protection around an address
struct Memory {
    uint64_t base, first;
    uint32_t firstProtection, partition;
    uint64_t size;
    uint32_t state, protection, kind, more;
};
static_assert(sizeof(Memory) == 48);
typedef PROBE_WINDOWS uint64_t Query(uint64_t address, Memory *, uint64_t size);

// The committed bytes of the stack below, counted up to 2 kFrame.
int64_t committed() {
    Memory memory;
    auto query = (Query *)function("kernel32.dll", "VirtualQuery");
    uint64_t here = (uint64_t)__builtin_frame_address(0), low = here;
    while (here - low < 2 * kFrame && query(low - 1, &memory, sizeof memory) == sizeof memory &&
           memory.state == 0x1000 && memory.protection == 4 /* to be written to, and no guard */)
        low = memory.base;
    return (int64_t)(here - low);
}

[[gnu::noinline]] void look(Found &found) {
    found.mxcsr = mxcsr();
    found.denormals = keepsDenormals();
    found.committed = committed();
    found.deep = deep();
    __atomic_store_n(&found.done, true, __ATOMIC_RELEASE);
}

void report(const char *mxcsrName, const char *denormals, const char *committed, const char *deep,
            const Found &f) {
    check(mxcsrName, f.mxcsr == kUsual, f.mxcsr);
    check(denormals, f.denormals);
    check(committed, f.committed >= kFrame, f.committed);
    check(deep, f.deep == kFrame / 4096, f.deep);
}
#define REPORT(who, found)                                                                                   \
    report("floats are rounded as on Linux in " who, "denormal ones survive in " who,                        \
           "the stack is committed in " who, "a large frame is written to in " who, found)

// Counts regions of the program's pages that are executable, and those that are executable and writable.
void countPages(uint64_t begin, uint64_t end, int &code, int &both) {
    auto query = (Query *)function("kernel32.dll", "VirtualQuery");
    Memory memory;
    for (; begin < end && query(begin, &memory, sizeof memory) == sizeof memory;
         begin = memory.base + memory.size) {
        code += (memory.protection & 0xf0) != 0;
        both += (memory.protection & 0xc0) != 0; // PAGE_EXECUTE_READWRITE, PAGE_EXECUTE_WRITECOPY
    }
}

// Threads begin with the float state that a bad library might leave
struct Start {
    void *body, *context;
} theStarts[kMaxWorkers];
int theStarted;
Instead *theCreateThread;

} // namespace

extern "C" void odrazProbeSpoilt();
__asm__("odrazProbeSpoilt:\n" // rcx: a Start
        "    push $0xffc0\n"
        "    ldmxcsr (%rsp)\n"
        "    pop %rax\n"
        "    mov (%rcx), %rax\n"
        "    mov 8(%rcx), %rcx\n"
        "    jmp *%rax\n");

namespace {

typedef PROBE_WINDOWS void *CreateThreadFunction(void *, uint64_t, void *, void *, uint32_t, uint32_t *);
PROBE_WINDOWS void *createSpoilt(void *security, uint64_t stack, void *body, void *context, uint32_t flags,
                                 uint32_t *id) {
    Start &start = theStarts[theStarted++];
    start = {body, context};
    return ((CreateThreadFunction *)theCreateThread->usual)(security, stack, (void *)odrazProbeSpoilt, &start,
                                                            flags, id);
}

// Unlike a worker's body this does not align the stack: the start of the thread must do so
void *threadBody(void *context) {
    Found &found = *(Found *)context;
    found.off = stackIsOff();
    look(found);
    return nullptr;
}

constexpr int kWorkers = 5;
struct Work {
    Found found[kWorkers];
    int arrived;
};
void workBody(const void *context, int piece, int, int worker) {
    Work &work = *(Work *)context;
    work.found[worker].off = stackIsOff();
    look(work.found[worker]);
    // Each worker takes one piece only
    __atomic_add_fetch(&work.arrived, 1, __ATOMIC_ACQ_REL);
    while (__atomic_load_n(&work.arrived, __ATOMIC_ACQUIRE) < kWorkers) Sleep(1);
    (void)piece;
}

} // namespace

void floats() {
    static Found main, thread;
    look(main);
    REPORT("the main thread", main);

    static Work work;
    static Workers workers;
    static const int never = 0;
    {
        Instead create(kernelSlot("CreateThread"), (void *)createSpoilt);
        theCreateThread = &create;
        setMxcsr(kSpoilt);
        const char *missing = startThread(threadBody, &thread);
        if (!missing) missing = startWorkers(workers, kWorkers, &never);
        setMxcsr(kUsual);
        check("threads start", !missing && theStarted == kWorkers, theStarted);
    }
    while (!__atomic_load_n(&thread.done, __ATOMIC_ACQUIRE)) Sleep(1);
    REPORT("a thread", thread);
    check("the stack is aligned for the engine in a thread", !thread.off, thread.off);
    workers.run(workers, kWorkers, 1, workBody, &work);
    for (int i = 1; i < kWorkers; ++i) {
        REPORT("a worker", work.found[i]);
        check("the stack is aligned for the engine in a worker", !work.found[i].off, work.found[i].off);
    }

    // The header sets the size of the main thread's stack and of every other, all of it committed
    auto module = (PROBE_WINDOWS char *(*)(const char *))function("kernel32.dll", "GetModuleHandleA");
    char *image = module(nullptr), *header = image + *(uint32_t *)(image + 0x3c) + 24;
    uint64_t reserved = *(uint64_t *)(header + 72), commits = *(uint64_t *)(header + 80);
    check("the file reserves a stack of 1 MB", reserved >= 1 << 20, (int64_t)reserved);
    check("... committed whole", commits == reserved, (int64_t)commits);

    int code = 0, both = 0;
    countPages((uint64_t)image, (uint64_t)image + *(uint32_t *)(header + 56), code, both);
    check("some of its pages may be executed", code > 0, code);
    check("... and none of these written to", !both, both);
}

} // namespace probe
