// The table of Windows's functions: windows.h declares them, calls.cpp calls them.
#pragma once

#include "base/gl.h"
#include "host/windows/windows.h"

namespace odraz::windows {

#define ODRAZ_ONE(name) +1
inline constexpr int kGlFunctions = sizeof(Gl) / sizeof(void *);

// The addresses of Windows's functions, in the order of the stubs; null if not loaded yet.
struct Functions {
    void *kernel32[ODRAZ_KERNEL32(ODRAZ_ONE)], *user32[ODRAZ_USER32(ODRAZ_ONE)],
        *gdi32[ODRAZ_GDI32(ODRAZ_ONE)], *opengl32[ODRAZ_OPENGL32(ODRAZ_ONE)], *winmm[ODRAZ_WINMM(ODRAZ_ONE)],
        *gl[kGlFunctions];
};

} // namespace odraz::windows

extern "C" {
extern odraz::windows::Functions odrazFunctions;
// The stubs that call the functions in odrazFunctions.gl. Each stub has the size of a pointer.
extern char odrazGlCalls[];
}
