// What the parts of the probe share: how they tell, and how they reach Windows.
#pragma once

#include "host/windows/calls.h"

#include <stddef.h>
#include <stdint.h>

namespace probe {

// "ok: WHAT", or "FAILED: WHAT" with what was found, on standard output. From the main thread only.
void check(const char *what, bool good, int64_t found = 0);
extern int failures;

// A function of Windows that the film does not use, to be cast to its type with ms_abi; never null.
void *function(const char *library, const char *name);
#define PROBE_WINDOWS __attribute__((ms_abi))

// In place of a function that the film calls, as long as one lives. `slot` is in odrazFunctions.
struct Instead {
    void **slot, *usual;
    Instead(void **slot, void *other) : slot(slot), usual(*slot) { *slot = other; }
    ~Instead() { *slot = usual; }
};
// Where the film looks for a function of kernel32.
void **kernelSlot(const char *name);

// Denormal floats are taken for zeros, sums are rounded towards zero, no error is silent: what a library
// might leave.
constexpr uint32_t kUsual = 0x1f80, kSpoilt = 0xffc0;
inline uint32_t mxcsr() { return __builtin_ia32_stmxcsr() & ~0x3fu; } // but for what has happened
inline void setMxcsr(uint32_t value) { __builtin_ia32_ldmxcsr(value); }

// 0, or by how much the stack is off what a function of the engine may take for granted. Inlined: of who asks
inline __attribute__((always_inline)) int64_t stackIsOff() {
    return ((int64_t)__builtin_frame_address(0) + 16) & 31;
}

// registers.cpp: the registers that a function has to keep, before and after a call of it
struct Kept {
    uint64_t whole[8];    // rbx, rbp, rdi, rsi, r12 .. r15
    uint64_t wide[10][2]; // xmm6 .. xmm15
    uint64_t result;
    int64_t stack; // rsp after less before
};
// By the convention of System V, whose functions keep only rbx, rbp and r12 to r15.
void callOurs(void *function, const uint64_t arguments[12], Kept &after);
// By Windows's, from a stack that is aligned as badly as Windows has it.
void callAsWindows(void *function, const uint64_t arguments[4], Kept &after);
bool keptByOurs(const Kept &); // all that was to be kept
bool keptByWindows(const Kept &);

// What the stub's calls of odrazEarly showed; early.cpp
struct Early {
    int calls, arguments;
    int64_t off; // of the stack's alignment, ever
    uint32_t last, size;
    bool wrong; // it went back, or beyond the end
};
extern Early theEarly;

// What the other files look at
void arguments();
void floats();
void names(const char *folder);
void passing();
void shown();
void times();

// starting.cpp: the status of a program that is started by a command line, without the standard handles
// `which`
// ("012"), as `how` says: null, invalid, stale. In a console of its own: its screen is written to standard
// output.
uint32_t start(const char *how, const char *which, const char *line);
uint32_t startInConsole(const char *which, const char *line);

} // namespace probe
