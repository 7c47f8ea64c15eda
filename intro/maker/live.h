// The film as odraz-debug calls it: a shared object that is built and loaded again while the film plays.
#pragma once

#include "maker/panel/inspector.h"
#include "maker/seam.h"
#include "timeline/key_table.h"

namespace odraz::maker {

struct Live {
#define FUNCTION(type, name, parameters, arguments) type(*name) parameters;
    ODRAZ_SEAM(FUNCTION, FUNCTION)
#undef FUNCTION
    const Inspector &(*inspector)();
    // A hash of what the hall's light is solved from: its shape, what it reflects, its lights and settings.
    // Takes hallHashMemory bytes of the arena
    uint64_t (*hallHash)(Arena &arena);
    size_t hallHashMemory;
    KeyTable *(*keyTables)(); // the first of all
    // Replaces a table's keys, of its own kind and at most kMostKeys, from the next picture on
    void (*setKeys)(KeyTable &table, const void *keys, int count);
    size_t sizes[4]; // of what load() and loadSound() make: where they differ, these must be called again
};

using GetLive = const Live *();
inline constexpr char kGetLive[] = "odrazLive"; // the one function that the shared object exports

} // namespace odraz::maker
