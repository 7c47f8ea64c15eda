// Where the shipped program starts on Windows: as a thread does, except that it has no argument.
#include "host/process.h"
#include "start/windows/command_line.h"

// Functions expect rsp 32-aligned where they are called, and floats that round as on Linux, denormal ones
// too: what is loaded with a program may have changed that.
__asm__(".globl _start\n"
        ".type _start, @function\n"
        "_start:\n"
        "    push $0x1f80\n"
        "    ldmxcsr (%rsp)\n"
        "    and $-32, %rsp\n"
        "    call odrazStart\n");

int odrazMain(int argc, char **argv);

extern "C" [[noreturn]] void odrazStart() {
    odraz::Arguments &arguments = odraz::commandLine();
    odraz::endProcess(odrazMain((int)arguments.count, arguments.values));
}
