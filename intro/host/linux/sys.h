// The kernel's calls, without libc. Results are the kernel's: negative is -errno.
//
// Everything here is static: these functions also run before the processor has been checked, so no copy of
// them compiled for a newer one may be linked in.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace odraz::sys {

enum Number : long {

    kWrite = 1,
    kOpen = 2,
    kClose = 3,
    kStat = 4,
    kFstat = 5,
    kPoll = 7,
    kMmap = 9,
    kSigaction = 13,
    kIoctl = 16,

    kNanosleep = 35,
    kFcntl = 72,
    kRename = 82,
    kMkdir = 83,
    kUnlink = 87,

    kFutex = 202,
    kGetAffinity = 204,
    kClockGettime = 228,
    kExitGroup = 231,
};

enum Error : long {
    kEnoent = 2,
    kEintr = 4,
    kEbadf = 9,
    kEacces = 13,
    kEexist = 17,
    kEnotdir = 20,
    kEisdir = 21,
    kEnospc = 28,
    kErofs = 30,
    kEpipe = 32
};

static inline long call(long number, long a = 0, long b = 0, long c = 0, long d = 0, long e = 0, long f = 0) {
    long result;
    register long r10 __asm__("r10") = d;
    register long r8 __asm__("r8") = e;
    register long r9 __asm__("r9") = f;
    __asm__ volatile("syscall"
                     : "=a"(result)
                     : "a"(number), "D"(a), "S"(b), "d"(c), "r"(r10), "r"(r8), "r"(r9)
                     : "rcx", "r11", "memory");
    return result;
}

// Waits until a descriptor has something to read, at most so long; false when nothing came.
static inline bool waitForInput(int descriptor, long milliseconds) {
    struct {
        int fd;
        short events, revents;
    } input = {descriptor, 1 /* POLLIN */, 0};
    return call(kPoll, (long)&input, 1, milliseconds) != 0;
}

[[noreturn]] static inline void exit(int status) {
    for (;;) call(kExitGroup, status);
}

} // namespace odraz::sys
