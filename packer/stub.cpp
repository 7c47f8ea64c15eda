// The code in front of every packed program. Baseline x86-64, no library, position-independent.
#include "decoder.h"
#include "filter.h"
#include "format.h"

extern const pack::Parameters parameters __attribute__((visibility("hidden")));

// ld.so's rdx (a function for exit) goes on to the program. Two pushes keep the stack aligned.
__asm__(".section .start, \"ax\"\n"
        ".globl _start\n"
        "_start:\n"
        "    push %rdx\n"
        "    push %rdx\n"
        "    call unpack\n"
        "    pop %rdx\n"
        "    pop %rdx\n"
        "    jmp *%rax\n"
        ".text\n");

static inline void kernel(long number, long a, long b, long c) {
    __asm__ volatile("syscall" : "+a"(number) : "D"(a), "S"(b), "d"(c) : "rcx", "r11", "memory");
}

extern "C" uint64_t unpack() {
    const pack::Parameters *all = &parameters;
    __asm__("" : "+r"(all)); // one address to count from, not eleven
    const pack::Parameters &p = *all;
    auto at = [](uint32_t address) { return (uint8_t *)(uint64_t)address; };
    // Keep what the loader has found for the program
    uint64_t *slots[2], found[2];
    for (int i = 0; i < 2; ++i) found[i] = *(slots[i] = (uint64_t *)at(p.slots[i]));
    pack::decode(at(p.payload), at(p.image), p.imageSize, *(pack::Model *)at(p.model));
    pack::filterAddresses<false>(at(p.image), p.codeSize, p.limit);
    for (int i = 0; i < 2; ++i) *slots[i] = found[i];
    kernel(10 /* mprotect */, p.image, p.codeSize, 5 /* read, execute */);
    kernel(11 /* munmap */, p.model, sizeof(pack::Model), 0);
    return p.entry;
}
