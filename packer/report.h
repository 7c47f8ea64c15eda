// What each part of a program costs, packed.
#pragma once

#include "program.h"

#include <map>
#include <string>

namespace pack {

struct Cost {
    uint64_t bytes = 0; // not packed
    double bits = 0;    // packed
};

struct Report {
    size_t fileSize, overhead; // of the packed file; overhead: what is not payload
    std::map<std::string, Cost> sections, objects, symbols;
};

// Whether the text is a map that GNU ld writes with -Map.
bool isMap(const std::string &text);

// `elf`: the program as it was read, for its sections and, if it is not stripped, its functions and objects.
// `map`: the linker's, for the object files; may be empty. `symbols`: what `nm -A` prints of the object files
// that are optimised as a whole when they are linked, which the map shows as one; may be empty. `bits`: the
// cost of each byte of `program`. Throws Unsuitable.
Report makeReport(const std::vector<uint8_t> &elf, const std::string &map, const std::string &symbols,
                  const Program &program, const std::vector<float> &bits, size_t fileSize, size_t overhead);

// As text: the object files by their cost, and the twenty costliest symbols.
std::string printReport(const Report &report);

// As JSON, one part a line, ordered by name.
std::string printJson(const Report &report);

} // namespace pack
