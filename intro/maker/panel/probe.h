// Notes what is done while a picture is made, without a change to the engine: the linker leads the calls of
// some of its functions here (--wrap, see CMakeLists.txt), from where they go on to the functions themselves.
// The film is linked without, so it is the same to the byte.
#pragma once

#include "maker/panel/inspector.h"

namespace odraz::maker {

// From now on this probe notes what happens; null: none. No picture may be in the making.
void watchPictures(Probe *probe);

} // namespace odraz::maker
