// Assembler source of the code that starts a program instead of crt1.
#pragma once

#include "packer/link/imports.h"

namespace pack::linking {

// For a dynamic program: with `whole`, __libc_start_main, which from glibc 2.34 on runs constructors; else,
// for a program without constructors, only main() and exit().
std::string startDynamic(bool whole);

// For the way `imports`. It opens the libraries and looks up all names in one loop, makes the copies, and
// runs constructors, main() and exit(). If a name is not found, it prints it on standard error and exits with
// status 127.
std::string startImports(const Plan &plan);

// The linker script that goes with it.
extern const char kImportsScript[];

} // namespace pack::linking
