// Finds the section, the object file and the symbol of each byte of a program: exactly one of each.
#pragma once

#include "packer/read/program.h"

#include <string>

namespace pack {

inline constexpr char kNothingNamed[] = "(nothing named)";
inline constexpr char kWholeProgram[] = "(optimised as a whole)"; // the single object that LTO makes

// Whether an object in a map is the single one that LTO makes. Its name differs at every link.
inline bool isWholeProgram(const std::string &object) { return object.find(".ltrans") != std::string::npos; }

// Adjacent bytes of a program that belong to the same parts.
struct Stretch {
    uint32_t begin, size; // in Program::bytes
    std::string section, object, room, symbol;
    // The symbol is demangled. Without a symbol or object, the name is "(nothing named in SECTION)". Object
    // and room are empty if there is no map.
    uint64_t units = 0; // the cost, in a Report (kUnit)
};

// The addresses of a part. Other parts may overlap them.
struct Claim {
    uint64_t begin, end;
    std::string name;
    std::string room = {}; // empty unless the part is an object file
};

// Sorts the claims. Returns the index of the claim of each of `size` bytes from the address `base` on, or
// kUnclaimed. Where claims overlap, the claim that begins last gets the byte. If several begin there, the
// shortest one gets it; among equally short ones, the first by name.
inline constexpr uint32_t kUnclaimed = UINT32_MAX;
std::vector<uint32_t> assignClaims(std::vector<Claim> &claims, uint64_t base, size_t size);

// An object file, and its archive or folder. A path is folder/lib.a(object.o) or folder/object.o.
struct Origin {
    std::string object, room;
};
Origin originOf(const std::string &path);

// Whether the text is a linker map, as GNU ld writes it with -Map.
bool isMap(const std::string &text);

// Returns the stretches of the whole program, in order. `elf`: the program's file, with its sections and,
// unless it is stripped, its functions and variables. `map`: the linker map with the object files, or empty.
// `symbols`: the output of `nm -A` for LTO objects, one object in the map; or empty. Throws common::Refused.
std::vector<Stretch> attribute(const Bytes &elf, const std::string &map, const std::string &symbols,
                               const Program &program);

} // namespace pack
