// Opens windows with contexts of OpenGL 3.3: the viewer's window, and a hidden one.
#pragma once

#include "base/gl.h"
#include "host/windows/windows.h"

namespace odraz::windows {

// Loads user32, gdi32 and opengl32. Returns null, or what is missing.
const char *openGlLibraries();

// A window and its device context. Calls on other threads wait for the thread that made the window, so a
// thread that only listens makes it. Its OpenGL context belongs to the thread that draws.
struct Surface {
    const char *kind; // its window class
    uint32_t style;
    int x, y, width, height;
    // Null if there is none
    Handle window = nullptr, dc = nullptr;
    Handle opened = nullptr; // a semaphore, released once the window is open or has failed to open
};

// Opens the window and listens, on a new thread. Returns null, or what is missing. If it returns null,
// `window` may still be null. The Surface must stay at its address afterwards.
const char *openSurface(Surface &);

// Returns a function of OpenGL or WGL, or null; a context must be current.
void *glFunction(const char *name);

// Makes a core context of OpenGL 3.3 for a device context, makes it current on this thread, and fills the
// table of its functions. Returns null, or what is missing.
const char *createContext(Handle dc, Gl &gl);

} // namespace odraz::windows
