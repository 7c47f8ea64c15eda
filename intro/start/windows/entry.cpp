// Where the shipped program starts on Windows: as a thread does, except that it has no argument.
#include "host/process.h"
#include "start/windows/command_line.h"

// Our functions expect rsp to be 32-aligned at a call, and floats to round as on Linux, denormal ones too:
// libraries loaded with the program may have changed that.
__asm__(".globl _start\n"
        ".type _start, @function\n"
        "_start:\n"
        "    push $0x1f80\n"
        "    ldmxcsr (%rsp)\n"
        "    and $-32, %rsp\n"
        "    call odrazStart\n");

int odrazMain(int argc, char **argv);

extern "C" [[noreturn]] void odrazStart() {
    odraz::CommandLine &line = odraz::commandLine();
    odraz::endProcess(odrazMain((int)line.count, line.values));
}
