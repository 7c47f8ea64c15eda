// OpenGL without a display: EGL's surfaceless platform.
#pragma once

#include "base/gl.h"

namespace odraz {

// Makes a core context of OpenGL 3.3 current on this thread and fills the table. Mesa's software renderer
// serves unless the environment asks for another. Returns null, or a line that says what is missing and what
// to do.
const char *openHeadlessGl(Gl &gl);

} // namespace odraz
