// Converts calls from System V's convention, in which all our code is compiled, to Microsoft's. Every
// function of windows.h and of OpenGL's table is a stub that calls odrazCall, which finds the function of
// Windows by its return address. A function has at most 12 arguments, and no float after an integer.
#include "host/windows/calls.h"

#include "host/library.h"

odraz::windows::Functions odrazFunctions; // filled as libraries are opened

#define CALL "    call odrazCall\n    .balign 8\n"
#define NAMED(name) ".globl " #name "\n" #name ":\n" CALL
#define UNNAMED(name) CALL

__asm__(".section .text.odrazCalls, \"ax\"\n"
        ".balign 8\n"
        "odrazCalls:\n" // in the order of Functions
        // clang-format off
        ODRAZ_KERNEL32(NAMED) ODRAZ_USER32(NAMED) ODRAZ_GDI32(NAMED) ODRAZ_OPENGL32(NAMED)
        ODRAZ_WINMM(NAMED)
        ".globl odrazGlCalls\n"
        "odrazGlCalls:\n"
        ODRAZ_GL(UNNAMED)
        // clang-format on
        "odrazCall:\n"
        "    pop %rax\n"
        "    push %rbp\n"
        "    mov %rsp, %rbp\n"
        // Push arguments 12 to 7, then 6 and 5. Below them, leave room for the first four
        "    push 56(%rbp)\n"
        "    push 48(%rbp)\n"
        "    push 40(%rbp)\n"
        "    push 32(%rbp)\n"
        "    push 24(%rbp)\n"
        "    push 16(%rbp)\n"
        "    push %r9\n"
        "    push %r8\n"
        "    sub $32, %rsp\n"
        "    mov %rcx, %r9\n"
        "    mov %rdx, %r8\n"
        "    mov %rsi, %rdx\n"
        "    mov %rdi, %rcx\n"
        "    call *odrazFunctions - 5 - odrazCalls(%rax)\n"
        "    leave\n"
        "    ret\n"
        ".text\n");

namespace odraz::windows {

void begin() { loadFunctions("kernel32.dll", ODRAZ_KERNEL32(ODRAZ_NAME), odrazFunctions.kernel32); }

} // namespace odraz::windows
