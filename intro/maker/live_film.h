// The film of the shared object. Programs that link this call the functions of intro.h, and get those
// of the object that was loaded last.
#pragma once

#include "maker/live.h"

#include <string>

namespace odraz::maker {

// Loads an object, even if one of that name is loaded. Returns null, and why in `wrong`, if it cannot. What
// was loaded stays in memory: what it has made points into it.
const Live *openLive(const std::string &file, std::string &wrong);

// From now on the functions of intro.h are these, and the music is that of `sound`.
void useLive(const Live *live, Sound *sound);

} // namespace odraz::maker
