// Headless OpenGL, through a hidden window.
#include "host/headless.h"

#include "host/process.h"
#include "host/windows/context.h"

namespace odraz {

using namespace windows;

const char *openHeadlessGl(Gl &gl) {
    if (const char *line = jitForbidden()) return line;
    if (!openGlLibraries()) {
        static Surface s = {"STATIC", 0x80000000 /* WS_POPUP */, 0, 0, 16, 16};
        if (!openSurface(s) && s.dc && !createContext(s.dc, gl)) return nullptr;
    }
    return "no OpenGL 3.3: install the driver of the graphics card";
}

} // namespace odraz
