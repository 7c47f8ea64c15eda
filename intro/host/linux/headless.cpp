// Headless OpenGL on EGL's surfaceless platform.
#include "host/headless.h"

#include "host/environment.h"
#include "host/library.h"
#include "host/process.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace odraz {

#define ODRAZ_EGL(F)                                                                                         \
    F(eglGetPlatformDisplay)                                                                                 \
    F(eglInitialize) F(eglBindAPI) F(eglCreateContext) F(eglMakeCurrent) F(eglGetProcAddress)
struct Egl {
    ODRAZ_EGL(ODRAZ_MEMBER)
};

const char *openHeadlessGl(Gl &gl) {
    static Egl egl;
    // Mesa does not check whether it got the memory that it asked for
    if (!couldAddress(1 << 30)) return "not enough memory for OpenGL: raise ulimit -v";
    // Software OpenGL generates code, and would crash without this permission
    if (const char *line = jitForbidden()) return line;
    // Render in software, so that pictures are equal on all machines, unless the environment says otherwise
    int (*setenv)(const char *, const char *, int);
    if (!loadFunctions(nullptr, "setenv\0", (void **)&setenv)) setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    if (loadFunctions("libEGL.so.1", ODRAZ_EGL(ODRAZ_NAME), (void **)&egl))
        return "libEGL.so.1 is missing: install libegl1 and libgl1-mesa-dri";
    EGLDisplay display = egl.eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (!display || !egl.eglInitialize(display, nullptr, nullptr) || !egl.eglBindAPI(EGL_OPENGL_API))
        return "no headless OpenGL 3.3: install libegl1 and libgl1-mesa-dri";
    static const EGLint kVersion[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EGLContext context = egl.eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kVersion);
    auto find = [](const char *name) { return (void *)egl.eglGetProcAddress(name); };
    if (!context || !egl.eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) || fillGl(find, gl))
        return causeOf("no headless OpenGL 3.3" ODRAZ_LOWERS_EGL "install libegl1 and libgl1-mesa-dri",
                       nullptr);
    return nullptr;
}

} // namespace odraz
