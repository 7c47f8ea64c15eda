// OpenGL without a display.
#pragma once

#include "base/gl.h"

namespace odraz {

// Makes a core context of OpenGL 3.3 current on this thread and fills the table. Mesa renders in software
// unless the environment has LIBGL_ALWAYS_SOFTWARE=0. Returns null, or a line that says what is missing and
// what to do.
const char *openHeadlessGl(Gl &gl);

} // namespace odraz
