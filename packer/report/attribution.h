// Which section, object file and symbol each byte of a program belongs to: one of each, and no byte twice.
#pragma once

#include "packer/read/program.h"

#include <string>

namespace pack {

inline constexpr char kNothingNamed[] = "(nothing named)";
inline constexpr char kWholeProgram[] = "(optimised as a whole)"; // the object that LTO makes of all others

// Whether an object in a map is that one; its name differs at every link.
inline bool isWholeProgram(const std::string &object) { return object.find(".ltrans") != std::string::npos; }

// Neighbouring bytes of a program that belong to the same parts.
struct Stretch {
    uint32_t begin, size; // in Program::bytes
    std::string section, object, room, symbol;
    // The symbol is demangled. What has no symbol is "(nothing named in SECTION)",
    // and so is what has no object. Room and object are empty if there is no map.
};

// The addresses of a part. Those of other parts may overlap them.
struct Claim {
    uint64_t begin, end;
    std::string name;
    std::string room = {}; // an object's
};

// For each of `size` bytes from the address `base` on, the number of the claim that has it, or kNobody. Sorts
// the claims. Where they overlap, the one that begins last has a byte, and of those that begin at one address
// the shortest; if that is the same, the first by name.
inline constexpr uint32_t kNobody = UINT32_MAX;
std::vector<uint32_t> owners(std::vector<Claim> &claims, uint64_t base, size_t size);

// An object file, and the archive or folder that it is in, from a path like folder/lib.a(object.o) or
// folder/object.o.
struct Home {
    std::string object, room;
};
Home homeOf(const std::string &path);

// Whether the text is a map that GNU ld writes with -Map.
bool isMap(const std::string &text);

// The stretches of the whole program, in order. `elf`: the program as it was read, for its sections and, if
// it is not stripped, its functions and objects. `map`: the linker's, for the object files; may be empty.
// `symbols`: what `nm -A` prints of LTO object files, which the map shows as one; may be empty. Throws
// common::Refused.
std::vector<Stretch> attribute(const Bytes &elf, const std::string &map, const std::string &symbols,
                               const Program &program);

} // namespace pack
