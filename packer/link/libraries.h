// Shared libraries and dynamic programs: what they need, define and import.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pack::linking {

struct DynamicSymbol {
    bool defined, function, threadLocal;
    bool constant; // it lies where nothing is written once the loader is done
    uint64_t size;
};

struct DynamicFile {
    std::string path, soname;
    std::vector<std::string> needed;
    std::map<std::string, DynamicSymbol> symbols; // without versions that only old programs get
    bool ownFolders;                              // it has a list of folders to find libraries in
    bool destructors;                             // others than those that every library has
};

// Throws common::Refused.
DynamicFile readDynamic(const std::string &path);

} // namespace pack::linking
