// System calls, without libc. Results are the kernel's: a negative one is -errno.
//
// Everything here is static, because these functions also run before the processor has been checked: the
// linker must not replace them by copies that were compiled for a newer processor.
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
    kMunmap = 11,
    kSigaction = 13,
    kIoctl = 16,
    kMadvise = 28,

    kDup2 = 33,
    kNanosleep = 35,
    kGetPid = 39,
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
    kEagain = 11,
    kEacces = 13,
    kEexist = 17,
    kEnotdir = 20,
    kEisdir = 21,
    kEfbig = 27,
    kEnospc = 28,
    kErofs = 30,
    kEpipe = 32,
    kEnametoolong = 36
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

enum Protection : long { kNothing = 0, kReadWrite = 3, kReadWriteExecute = 7 };

// Zeroed private memory, in whole pages; null if the system refuses.
static inline void *map(size_t bytes, Protection protection) {
    long p = call(kMmap, 0, (long)bytes, protection, 0x22 /* private, anonymous */, -1, 0);
    return p < 0 && p > -4096 ? nullptr : (void *)p;
}

enum Ready : short { kInput = 1, kOutput = 4 };

// Waits until a descriptor can be read or written, for `milliseconds` at most (-1: no limit). Returns false
// on a timeout.
static inline bool waitFor(int descriptor, Ready what, long milliseconds) {
    struct {
        int fd;
        short events, revents;
    } request = {descriptor, what, 0};
    return call(kPoll, (long)&request, 1, milliseconds) != 0;
}

[[noreturn]] static inline void exit(int status) {
    for (;;) call(kExitGroup, status);
}

} // namespace odraz::sys
