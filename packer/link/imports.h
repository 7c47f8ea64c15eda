// The plan of the way `imports`: what a program imports, and in which form.
#pragma once

#include "packer/link/libraries.h"
#include "packer/link/objects.h"

namespace pack::linking {

// All names are looked up when the program starts, each into a slot of eight bytes. In the program a name is
// one of three things: the slot itself, for objects that use the GOT (-fno-plt, -fPIC); a jump through the
// slot, for functions that are called or named directly; a copy made at the start, for data that is named
// directly.
struct Import {
    enum Form { kSlot, kJump, kCopy } form;
    std::string name;
    uint64_t size; // of a copy, in bytes
};

struct Plan {
    std::vector<std::string> libraries; // to open, by soname
    std::vector<Import> imports;        // sorted by name, which packs best
    bool constructors, destructors;
    bool whole; // needsWholeStart()
};

// `program` is the same program linked dynamically, with `libraries`. Throws common::Refused with the reason
// if the program cannot be linked this way.
Plan planImports(const std::vector<Object> &objects, const DynamicFile &program,
                 const std::vector<DynamicFile> &libraries);

// Whether the program must start and end through __libc_start_main: the thread of main() may end before the
// process does, or a library outside the system's folders has destructors. Otherwise calling exit() is
// enough.
bool needsWholeStart(const DynamicFile &program, const std::vector<DynamicFile> &libraries);

} // namespace pack::linking
