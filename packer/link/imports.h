// What a program imports, and how it can find that by itself: the plan of the way `imports`.
#pragma once

#include "packer/link/libraries.h"
#include "packer/link/objects.h"

namespace pack::linking {

// All names are looked up when the program starts, each into a slot of eight bytes. Each has one of three
// forms in the program: the slot itself, for objects that reach it by way of the GOT (-fno-plt, -fPIC); a
// jump through the slot, for functions that are called or named directly; or, for data that is named
// directly, a copy made at the start.
struct Import {
    enum Form { kSlot, kJump, kCopy } form;
    std::string name;
    uint64_t size; // of a copy, in bytes
};

struct Plan {
    std::vector<std::string> libraries; // to open, by soname
    std::vector<Import> imports;        // sorted by name: so they pack best
    bool constructors, destructors;
    bool whole; // start by libc's own function: see needsWholeStart
};

// `program` is the same program linked dynamically, `libraries` what it took. Throws common::Refused, with a
// line that names what stands in the way.
Plan planImports(const std::vector<Object> &objects, const DynamicFile &program,
                 const std::vector<DynamicFile> &libraries);

// Whether the program must start and end by __libc_start_main: the thread of main() may end alone, or a
// library that is not of the system has destructors. Else exit() at the end is enough.
bool needsWholeStart(const DynamicFile &program, const std::vector<DynamicFile> &libraries);

} // namespace pack::linking
