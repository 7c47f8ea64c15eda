// Calls functions with a different number in every register that must be kept.
#include "probe.h"

namespace probe {

namespace {

constexpr uint64_t kWhole = 0x0123456789abcd00, kLow = 0x1111222233334400, kHigh = 0x5555666677778800;

bool wholeIs(const Kept &k, int i) { return k.whole[i] == kWhole + (uint64_t)i; }

} // namespace

// Used by the assembler below: the result, the function, its arguments, the stack before the call, and the
// registers to set.
extern "C" {
Kept *probeAfter;
void *probeFunction;
const uint64_t *probeArguments;
uint64_t probeStack, probeBefore[28];
void probeCallOurs();
void probeCallAsWindows();
}

#define SAVE_OWN                                                                                             \
    "push %rbp\n push %rbx\n push %r12\n push %r13\n push %r14\n push %r15\n mov %rsp, probeStack\n"
#define LOAD_OWN "mov probeStack, %rsp\n pop %r15\n pop %r14\n pop %r13\n pop %r12\n pop %rbx\n pop %rbp\n"
// After a call; probeFunction then holds rsp from before it
#define KEEP                                                                                                 \
    "push %rax\n mov probeAfter, %rax\n"                                                                     \
    "mov %rbx, (%rax)\n mov %rbp, 8(%rax)\n mov %rdi, 16(%rax)\n mov %rsi, 24(%rax)\n"                       \
    "mov %r12, 32(%rax)\n mov %r13, 40(%rax)\n mov %r14, 48(%rax)\n mov %r15, 56(%rax)\n"                    \
    "movups %xmm6, 64(%rax)\n movups %xmm7, 80(%rax)\n movups %xmm8, 96(%rax)\n movups %xmm9, 112(%rax)\n"   \
    "movups %xmm10, 128(%rax)\n movups %xmm11, 144(%rax)\n movups %xmm12, 160(%rax)\n"                       \
    "movups %xmm13, 176(%rax)\n movups %xmm14, 192(%rax)\n movups %xmm15, 208(%rax)\n"                       \
    "pop %rcx\n mov %rcx, 224(%rax)\n mov %rsp, %rcx\n sub probeFunction, %rcx\n mov %rcx, 232(%rax)\n"
#define SET                                                                                                  \
    "mov probeBefore, %rbx\n mov probeBefore + 8, %rbp\n mov probeBefore + 32, %r12\n"                       \
    "mov probeBefore + 40, %r13\n mov probeBefore + 48, %r14\n mov probeBefore + 56, %r15\n"

__asm__(".text\n"
        "probeCallOurs:\n" SAVE_OWN "and $-32, %rsp\n sub $16, %rsp\n"
        "mov probeArguments, %rax\n"
        "push 88(%rax)\n push 80(%rax)\n push 72(%rax)\n push 64(%rax)\n push 56(%rax)\n push 48(%rax)\n"
        "mov (%rax), %rdi\n mov 8(%rax), %rsi\n mov 16(%rax), %rdx\n mov 24(%rax), %rcx\n"
        "mov 32(%rax), %r8\n mov 40(%rax), %r9\n" SET "mov probeFunction, %rax\n mov %rsp, probeFunction\n"
        "call *%rax\n" KEEP LOAD_OWN "ret\n"

        "probeCallAsWindows:\n" SAVE_OWN
        "and $-32, %rsp\n sub $48, %rsp\n" // aligned by 16 and no more, with room for four arguments
        "mov probeArguments, %rax\n"
        "mov (%rax), %rcx\n mov 8(%rax), %rdx\n mov 16(%rax), %r8\n mov 24(%rax), %r9\n" SET
        "mov probeBefore + 16, %rdi\n mov probeBefore + 24, %rsi\n"
        "movups probeBefore + 64, %xmm6\n movups probeBefore + 80, %xmm7\n movups probeBefore + 96, %xmm8\n"
        "movups probeBefore + 112, %xmm9\n movups probeBefore + 128, %xmm10\n"
        "movups probeBefore + 144, %xmm11\n movups probeBefore + 160, %xmm12\n"
        "movups probeBefore + 176, %xmm13\n movups probeBefore + 192, %xmm14\n"
        "movups probeBefore + 208, %xmm15\n"
        "mov probeFunction, %rax\n mov %rsp, probeFunction\n"
        "call *%rax\n" KEEP LOAD_OWN "ret\n");
static_assert(offsetof(Kept, wide) == 64 && offsetof(Kept, result) == 224 && offsetof(Kept, stack) == 232);

static void call(void (*how)(), void *function, const uint64_t *arguments, Kept &after) {
    for (uint64_t i = 0; i < 8; ++i) probeBefore[i] = kWhole + i;
    for (uint64_t i = 0; i < 10; ++i) probeBefore[8 + 2 * i] = kLow + i, probeBefore[9 + 2 * i] = kHigh + i;
    probeAfter = &after;
    probeFunction = function;
    probeArguments = arguments;
    how();
}

void callOurs(void *function, const uint64_t arguments[12], Kept &after) {
    call(probeCallOurs, function, arguments, after);
}

void callAsWindows(void *function, const uint64_t arguments[4], Kept &after) {
    call(probeCallAsWindows, function, arguments, after);
}

bool keptByOurs(const Kept &k) {
    for (int i = 0; i < 8; ++i)
        if (i != 2 && i != 3 && !wholeIs(k, i)) return false;
    return !k.stack;
}

bool keptByWindows(const Kept &k) {
    for (int i = 0; i < 8; ++i)
        if (!wholeIs(k, i)) return false;
    for (uint64_t i = 0; i < 10; ++i)
        if (k.wide[i][0] != kLow + i || k.wide[i][1] != kHigh + i) return false;
    return !k.stack;
}

} // namespace probe
