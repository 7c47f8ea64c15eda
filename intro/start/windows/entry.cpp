// The entry of the shipped program on Windows. It is called as a thread's body is, but without an argument.
#include "host/process.h"
#include "start/windows/command_line.h"

// Our functions expect rsp to be 32-aligned at a call, and mxcsr (rounding, denormal floats) as on Linux.
// Libraries that were loaded with the program may have changed mxcsr.
__asm__(".globl _start\n"
        ".type _start, @function\n"
        "_start:\n"
        "    push $0x1f80\n"
        "    ldmxcsr (%rsp)\n"
        "    and $-32, %rsp\n"
        "    call odrazStart\n");

int odrazMain(int argc, char **argv);

extern "C" [[noreturn]] void odrazStart() {
    odraz::Arguments &line = odraz::arguments();
    odraz::endProcess(odrazMain((int)line.count, line.values));
}
