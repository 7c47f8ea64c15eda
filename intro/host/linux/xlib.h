// The functions of Xlib that we use, as a table.
#pragma once

#include "host/library.h"

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace odraz {

// clang-format off
#define ODRAZ_XLIB(F) \
    F(XInitThreads) F(XOpenDisplay) F(XCloseDisplay) F(XCreateWindow) F(XMapRaised) \
    F(XNextEvent) F(XPending) F(XSync) F(XFlush) F(XInternAtom) F(XSetWMProtocols) F(XChangeProperty) \
    F(XStoreName) F(XSetInputFocus) F(XCreateColormap) \
    F(XCreateBitmapFromData) F(XCreatePixmapCursor) F(XDefineCursor) F(XResetScreenSaver) \
    F(XSetErrorHandler) F(XSetIOErrorHandler) F(XLookupKeysym) F(XCreateGC) F(XDrawString) \
    F(XSetForeground) F(XSendEvent) F(XResizeWindow) F(XkbSetDetectableAutoRepeat)
// clang-format on

struct Xlib {
    ODRAZ_XLIB(ODRAZ_MEMBER)
};

static inline const char *loadXlib(Xlib &x) {
    return loadFunctions("libX11.so.6", ODRAZ_XLIB(ODRAZ_NAME), (void **)&x);
}

} // namespace odraz
