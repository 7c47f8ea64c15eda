// The film of the shared object. Whoever links this calls the functions of intro.h as ever, and gets those of
// the object that was loaded last.
#pragma once

#include "maker/live.h"
#include "maker/symbols.h"

#include <string>

namespace odraz {

// Loads an object that may have the name of one that is loaded. Returns null, and why in `wrong`, if it is
// none. `symbols`, if given, gets the names of its tables. What was loaded stays in memory: what it has made
// points into it.
const Live *openLive(const std::string &file, std::string &wrong, std::vector<Symbol> *symbols = nullptr);

// From now on the functions of intro.h are these, and the music is that of `sound`.
void useLive(const Live *live, Sound *sound);
const Live *liveInUse();

} // namespace odraz
