// Contexts of OpenGL 3.3 on windows: for the viewer's, and for one that nobody sees.
#pragma once

#include "base/gl.h"
#include "host/windows/windows.h"

namespace odraz::windows {

// user32, gdi32 and opengl32: null, or what is missing.
const char *openGlLibraries();

// A function of OpenGL or WGL, where a context is current; null: there is none.
void *glFunction(const char *name);

// A core context of OpenGL 3.3 for a window's device, current on this thread, and the table of its functions.
// Null, or what is missing.
const char *createContext(Handle dc, Gl &gl);

} // namespace odraz::windows
