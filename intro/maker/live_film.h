// Implements the functions of intro.h by calling the shared object that useLive() named last.
#pragma once

#include "maker/live.h"

#include <string>

namespace odraz::maker {

// Loads an object, even if one of that name is loaded already. If it cannot, returns null, with the reason in
// `wrong`. Objects are never unloaded, because data that they made point into them.
const Live *openLive(const std::string &file, std::string &wrong);

// From now on the functions of intro.h call `live`, and the music thread plays `sound`.
void useLive(const Live *live, Sound *sound);

} // namespace odraz::maker
