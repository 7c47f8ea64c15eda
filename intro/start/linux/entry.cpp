// The entry of the shipped program, without crt1 and libc's start-up. The program has an interpreter, so
// ld.so has initialised libc by now: malloc and threads of the libraries work.
#include "host/process.h"

// At entry rsp points to argc. Our functions expect rsp to be 32-aligned at a call.
__asm__(".globl _start\n"
        ".type _start, @function\n"
        "_start:\n"
        "    xor %ebp, %ebp\n"
        "    mov %rsp, %rdi\n"
        "    and $-32, %rsp\n"
        "    call odrazStart\n");

int odrazMain(int argc, char **argv);

extern "C" [[noreturn]] void odrazStart(long *stack) {
    odraz::endProcess(odrazMain((int)stack[0], (char **)(stack + 1)));
}
