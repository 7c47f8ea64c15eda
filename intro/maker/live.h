// The film as odraz-debug calls it: a shared object that is rebuilt and reloaded while the film plays.
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
    // Hashes the input of the hall's light: geometry, reflectance, lights, settings. Needs hallHashMemory
    // bytes of the arena
    uint64_t (*hallHash)(Arena &arena);
    size_t hallHashMemory;
    KeyTable *(*keyTables)(); // the head of the list of all tables
    // Replaces a table's keys from the next picture on. `keys`: at most kMostKeys, of the table's type
    void (*setKeys)(KeyTable &table, const void *keys, int count);
    // Bytes of Intro, Scene, Hall and Sound. If one changes, load() and loadSound() must run again
    size_t sizes[4];
};

using GetLive = const Live *();
inline constexpr char kGetLive[] = "odrazLive"; // the one function that the shared object exports

} // namespace odraz::maker
