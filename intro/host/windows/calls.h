// The table through which Windows's functions are called: windows.h names the functions, calls.cpp calls
// them.
#pragma once

#include "base/gl.h"
#include "host/windows/windows.h"

namespace odraz::windows {

#define ODRAZ_ONE(name) +1
inline constexpr int kGlFunctions = sizeof(Gl) / sizeof(void *);

// A function of Windows for each of ours, in the same order. What is not loaded yet is null.
struct Functions {
    void *kernel32[ODRAZ_KERNEL32(ODRAZ_ONE)], *user32[ODRAZ_USER32(ODRAZ_ONE)],
        *gdi32[ODRAZ_GDI32(ODRAZ_ONE)], *opengl32[ODRAZ_OPENGL32(ODRAZ_ONE)], *winmm[ODRAZ_WINMM(ODRAZ_ONE)],
        *gl[kGlFunctions];
};

} // namespace odraz::windows

extern "C" {
extern odraz::windows::Functions odrazFunctions;
// The first of the stubs that call the functions in odrazFunctions.gl; each stub takes as many bytes as a
// pointer.
extern char odrazGlCalls[];
}
