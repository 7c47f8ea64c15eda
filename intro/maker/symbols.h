// What the tables of a shared object are called in its source.
#pragma once

#include "maker/live_tables.h"

#include <cstdint>
#include <string>
#include <vector>

namespace odraz {

struct Symbol {
    const char *at; // in this process
    size_t size;
    std::string name;      // without its namespaces, as in "kDoor"
    std::string file = {}; // of the source, "day.cpp"; empty: not told
};

// The objects in a file of which one function, called `known`, was loaded to `address`. None if the file is
// not of that kind, or was stripped.
std::vector<Symbol> readSymbols(const std::string &file, const std::string &known, const void *address);

// The symbol that a table is of, or null. `element`: which one, if the symbol is an array of tables; else -1.
const Symbol *symbolOf(const std::vector<Symbol> &symbols, const Table &table, int &element);

} // namespace odraz
