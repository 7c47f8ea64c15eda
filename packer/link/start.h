// The source, in assembler, of what starts a program in place of crt1.
#pragma once

#include "packer/link/imports.h"

namespace pack::linking {

// For a dynamic program: the least that glibc 2.34 or later needs, which runs constructors by itself; without
// `whole`, for a program without constructors: main() and exit().
std::string startDynamic(bool whole);

// For the way `imports`. It opens libraries and looks for all names, in one loop: what is not a function's
// name is a library's. What is missing is named on standard error, and the exit status is 127. Then come
// copies, constructors, main() and exit().
std::string startImports(const Plan &plan);

// ... and how its sections lie: a script for the linker.
extern const char kImportsScript[];

} // namespace pack::linking
