// Shared libraries and dynamic programs: what they need, define and import.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pack::linking {

struct DynamicSymbol {
    bool defined, function, threadLocal;
    bool constant; // nothing writes it after the loader
    uint64_t size;
};

struct DynamicFile {
    std::string path, soname;
    std::vector<std::string> needed;
    std::map<std::string, DynamicSymbol> symbols; // without versions kept for old programs
    bool ownFolders;                              // it has an -rpath
    bool destructors;                             // besides the one in every library
};

// Throws common::Refused.
DynamicFile readDynamic(const std::string &path);

} // namespace pack::linking
