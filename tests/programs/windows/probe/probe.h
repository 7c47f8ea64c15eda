// Shared by the parts of the probe: how they report, and how they reach Windows.
#pragma once

#include "host/windows/calls.h"

#include <stddef.h>
#include <stdint.h>

namespace probe {

// "ok: WHAT", or "FAILED: WHAT" with what was found, on standard output. From the main thread only.
void check(const char *what, bool good, int64_t found = 0);
extern int failures;
// Whether two texts are equal; false if the first is null.
bool is(const char *text, const char *other);

// A function of Windows that the film does not use; cast it to its type with ms_abi. Never null.
void *function(const char *library, const char *name);
#define PROBE_WINDOWS __attribute__((ms_abi))

// Replaces a function that the film calls, as long as the object lives. `slot` is an index in odrazFunctions.
struct Instead {
    void **slot, *usual;
    Instead(void **slot, void *other) : slot(slot), usual(*slot) { *slot = other; }
    ~Instead() { *slot = usual; }
};
// The slot of a function of kernel32, where the film looks it up.
void **kernelSlot(const char *name);

// kSpoilt is a state that a bad library might leave: denormals count as zero, sums round towards zero, every
// float error traps.
constexpr uint32_t kUsual = 0x1f80, kSpoilt = 0xffc0;
inline uint32_t mxcsr() { return __builtin_ia32_stmxcsr() & ~0x3fu; } // without the flags of past errors
inline void setMxcsr(uint32_t value) { __builtin_ia32_ldmxcsr(value); }

// 0, or the misalignment of the stack against what the engine's functions assume. Inlined, so that it tests
// its caller
inline __attribute__((always_inline)) int64_t stackIsOff() {
    return ((int64_t)__builtin_frame_address(0) + 16) & 31;
}

// registers.cpp: the registers that a function must keep, before and after a call
struct Kept {
    uint64_t whole[8];    // rbx, rbp, rdi, rsi, r12 .. r15
    uint64_t wide[10][2]; // xmm6 .. xmm15
    uint64_t result;
    int64_t stack; // rsp after the call minus before
};
// Calls by the convention of System V, whose functions keep only rbx, rbp and r12 to r15.
void callOurs(void *function, const uint64_t arguments[12], Kept &after);
// Calls by Windows's convention, with the stack as badly aligned as Windows may leave it.
void callAsWindows(void *function, const uint64_t arguments[4], Kept &after);
bool keptByOurs(const Kept &); // whether all registers were kept
bool keptByWindows(const Kept &);

// What the stub's calls of odrazEarly showed (early.cpp)
struct Early {
    int calls, arguments;
    int64_t off; // of the stack's alignment, ever
    uint32_t last, size;
    bool wrong; // it went back, or beyond the end
};
extern Early theEarly;

// The parts, one in each file
void arguments();
void floats();
void names(const char *folder);
void passing();
void shown();
void times();

// starting.cpp: start a program by a command line without the standard handles `which`, such as "012", and
// return its status. `how` these handles are missing: null, invalid or stale. startInConsole() starts it in a
// new console, and writes the console's screen to standard output.
uint32_t start(const char *how, const char *which, const char *line);
uint32_t startInConsole(const char *which, const char *line);

} // namespace probe
