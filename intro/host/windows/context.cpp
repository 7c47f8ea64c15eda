#include "host/windows/context.h"

#include "film.h"
#include "host/library.h"
#include "host/threads.h"
#include "host/windows/calls.h"

namespace odraz::windows {

static void *listen(void *context) {
    Surface &s = *(Surface *)context;
    s.window = CreateWindowExA(0, s.kind, FILM_NAME, s.style, s.x, s.y, s.width, s.height, nullptr, nullptr,
                               nullptr, nullptr);
    if (s.window) s.dc = GetDC(s.window);
    ReleaseSemaphore(s.opened, 1, nullptr);
    uint64_t message[6];
    while (s.window && GetMessageA(message, nullptr, 0, 0) > 0) DispatchMessageA(message);
    return nullptr;
}

const char *openSurface(Surface &s) {
    s.opened = CreateSemaphoreA(nullptr, 0, 1, nullptr);
    if (!s.opened || startThread(listen, &s)) return "no thread to listen for keys: end other programs";
    WaitForSingleObject(s.opened, ~0u);
    return nullptr;
}

// wglGetProcAddress finds functions newer than OpenGL 1.1; the library has the older ones. Some drivers
// return small numbers instead of null.
void *glFunction(const char *name) {
    void *found = wglGetProcAddress(name);
    return (uintptr_t)found + 1 > 4 ? found : GetProcAddress(LoadLibraryA("opengl32.dll"), name);
}

const char *openGlLibraries() {
    if (const char *missing = loadFunctions("user32.dll", ODRAZ_USER32(ODRAZ_NAME), odrazFunctions.user32))
        return missing;
    if (const char *missing = loadFunctions("gdi32.dll", ODRAZ_GDI32(ODRAZ_NAME), odrazFunctions.gdi32))
        return missing;
    return loadFunctions("opengl32.dll", ODRAZ_OPENGL32(ODRAZ_NAME), odrazFunctions.opengl32);
}

const char *createContext(Handle dc, Gl &gl) {
    static const char kContext[] = "wglCreateContextAttribsARB";
    PixelFormat format = {};
    format.size = sizeof format;
    format.version = 1;
    format.flags = 0x25; // draw to a window, support OpenGL, double buffer
    format.colourBits = 24;
    if (!SetPixelFormat(dc, ChoosePixelFormat(dc, &format), &format)) return "a pixel format";
    // The function that makes a context of a given version can be found only while a context is current
    if (!wglMakeCurrent(dc, wglCreateContext(dc))) return "OpenGL";
    auto create = (__attribute__((ms_abi)) Handle(*)(Handle, Handle, const int *))glFunction(kContext);
    static const int kVersion[] = {0x2091 /* WGL_CONTEXT_MAJOR_VERSION_ARB */,
                                   3,
                                   0x2092 /* WGL_CONTEXT_MINOR_VERSION_ARB */,
                                   3,
                                   0x9126 /* WGL_CONTEXT_PROFILE_MASK_ARB */,
                                   1 /* core */,
                                   0};
    Handle made = create ? create(dc, nullptr, kVersion) : nullptr;
    if (!made || !wglMakeCurrent(dc, made)) return kContext;
    return fillGl(glFunction, gl);
}

} // namespace odraz::windows
