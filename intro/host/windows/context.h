// Windows and contexts of OpenGL 3.3 on them: the viewer's, and one that nobody sees.
#pragma once

#include "base/gl.h"
#include "host/windows/windows.h"

namespace odraz::windows {

// user32, gdi32 and opengl32: null, or what is missing.
const char *openGlLibraries();

// A window belongs to a thread that listens, as Windows has it: others send it messages, and wait. Its
// context belongs to the thread that draws.
struct Surface {
    const char *kind; // its class
    uint32_t style;
    int x, y, width, height;
    // Null where there is none
    Handle window = nullptr, dc = nullptr;
    Handle opened = nullptr; // a semaphore, given when it is there or cannot be
};

// Opens it and listens, on a thread of its own. Null, or what is missing; a window may be missing all the
// same. It stays where it is.
const char *openSurface(Surface &);

// A function of OpenGL or WGL, where a context is current; null: there is none.
void *glFunction(const char *name);

// A core context of OpenGL 3.3 for a window's device, current on this thread, and the table of its functions.
// Null, or what is missing.
const char *createContext(Handle dc, Gl &gl);

} // namespace odraz::windows
