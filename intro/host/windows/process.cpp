#include "host/process.h"

#include "host/windows/windows.h"

namespace odraz {

using namespace windows;

namespace {

constexpr uint32_t kReserve = 0x2000, kCommit = 0x1000, kDecommit = 0x4000, kRelease = 0x8000, kNothing = 1,
                   kReadWrite = 4, kReadWriteExecute = 0x40;

bool mayTake(size_t bytes, uint32_t how, uint32_t protection) {
    void *memory = VirtualAlloc(nullptr, bytes, how, protection);
    return memory && VirtualFree(memory, 0, kRelease);
}

constexpr uint32_t which(int descriptor) { return (uint32_t)(-10 - descriptor); }

} // namespace

HANDLE windows::standard(int descriptor) { return GetStdHandle(which(descriptor)); }

const char kMoreMemory[] = "end other programs";

void *takeMemory(size_t bytes) { return VirtualAlloc(nullptr, bytes, kReserve | kCommit, kReadWrite); }

void giveBack(void *memory, size_t bytes) {
    uint64_t from = ((uint64_t)memory + 4095) & ~4095ull;
    VirtualFree((void *)from, ((uint64_t)memory + bytes - from) & ~4095ull, kDecommit);
}

const char *jitForbidden() {
    return mayTake(4096, kReserve | kCommit, kReadWriteExecute)
               ? nullptr
               : "arbitrary code guard forbids code that OpenGL generates: allow it, or dump a scene without "
                 "the hall";
}

bool couldAddress(size_t bytes) { return mayTake(bytes, kReserve, kNothing); }

Quiet::Quiet() {} // on Windows, libraries write nothing to standard error
Quiet::~Quiet() {}

int prepareDescriptors() {
    int closed = 0;
    HANDLE to[3];
    for (int fd = 0; fd < 3; ++fd)
        if (!GetFileType(to[fd] = standard(fd))) {
            closed |= 1 << fd;
            SetStdHandle(which(fd), nullptr); // so that no file of ours becomes a standard descriptor
        }
    // Attach the console of the parent process. That also replaces pipes and files, which are put back
    static const WCHAR kConsole[] = {'C', 'O', 'N', 'O', 'U', 'T', '$', 0};
    if (closed & 6 && AttachConsole(~0u /* the parent process's */))
        for (int fd = 1; fd < 3; ++fd) {
            if (closed >> fd & 1) to[fd] = CreateFileW(kConsole, 0xc0000000, 3, nullptr, 3, 0, nullptr);
            if (to[fd] != kInvalid && SetStdHandle(which(fd), to[fd])) closed &= ~(1 << fd);
        }
    return closed;
}

void endProcess(int status) {
    for (;;) TerminateProcess(kInvalid, (uint32_t)status);
}

} // namespace odraz
