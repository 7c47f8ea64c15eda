// Object files, alone or in archives: what links and imports need of them.
#pragma once

#include "packer/read/bytes.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace pack::linking {

// A relocation that names a symbol which its object does not define.
struct Reference {
    std::string symbol;
    uint32_t type; // R_X86_64_...
    size_t place;  // of the relocation's entry in the object
};

// What an object holds: machine code, the LTO code of gcc or clang, or neither.
enum class Code { kMachine, kGcc, kClang, kNone };

struct Object {
    std::string path, member; // member: in the archive `path`; empty if the file is the object
    size_t offset;            // of its bytes in the file
    Bytes bytes;
    std::vector<Reference> references; // from loaded sections, except .eh_frame
    std::set<std::string> defines;     // global symbols
    bool constructors, destructors, exceptions, threadLocal;
    bool indirect;        // it has ifuncs, which are chosen at the start
    bool oldConstructors; // in .ctors, .dtors, .init or .fini
    Code code;
    std::string name() const { return member.empty() ? path : path + "(" + member + ")"; }
};

enum class FileKind { kObject, kArchive, kThinArchive, kLibrary, kProgram, kBitcode, kOther, kMissing };
FileKind kindOf(const std::string &path);

// An object file, or the members of an archive. Throws common::Refused if one cannot be read.
std::vector<Object> readObjects(const std::string &path);

// What a link used, by GNU ld's map; empty if it is the map of another linker.
struct Taken {
    std::vector<std::string> files;                        // all that were opened, in order
    std::set<std::pair<std::string, std::string>> members; // archive and member, of those linked
};
Taken readLinkerMap(const std::string &map);

// Turns GOT references to `symbols` into direct ones, because these symbols are the slots themselves. Returns
// whether there were any.
bool makeSlots(Object &object, const std::set<std::string> &symbols);

} // namespace pack::linking
