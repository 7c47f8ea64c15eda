#include "film.h"
#include "host/linux/sys.h"
#include "host/linux/xlib.h"
#include "host/process.h"

namespace odraz {

int showError(const char *line) {
    printError(line);
    Xlib x;
    if (loadXlib(x)) return 1;
    Display *display = x.XOpenDisplay(nullptr);
    if (!display) return 1;
    // Estimate the width: characters of the core font "fixed" are six pixels wide
    int length = 0;
    while (line[length]) ++length;
    int screen = DefaultScreen(display), width = 6 * length + 48, height = 72;
    XSetWindowAttributes attributes = {};
    attributes.background_pixel = BlackPixel(display, screen);
    attributes.event_mask = ExposureMask | KeyPressMask | ButtonPressMask;
    Window window =
        x.XCreateWindow(display, RootWindow(display, screen), 40, 40, (unsigned)width, (unsigned)height, 0,
                        CopyFromParent, InputOutput, nullptr, CWBackPixel | CWEventMask, &attributes);
    x.XStoreName(display, window, FILM_NAME);
    Atom close = x.XInternAtom(display, "WM_DELETE_WINDOW", False);
    x.XSetWMProtocols(display, window, &close, 1);
    GC pen = x.XCreateGC(display, window, 0, nullptr);
    x.XSetForeground(display, pen, WhitePixel(display, screen));
    x.XMapRaised(display, window);
    // Wait for at most half a minute: a script that runs the film on a display must not hang
    for (;;) {
        x.XFlush(display);
        if (!x.XPending(display) && !sys::waitFor(ConnectionNumber(display), sys::kInput, 30000)) break;
        XEvent event;
        x.XNextEvent(display, &event);
        if (event.type == Expose) x.XDrawString(display, window, pen, 24, 40, line, length);
        if (event.type == KeyPress || event.type == ButtonPress || event.type == ClientMessage) break;
    }
    x.XCloseDisplay(display);
    return 1;
}

} // namespace odraz
