// The viewer's window, on X11 and GLX.
#include "host/window.h"

#include "film.h"
#include "host/clock.h"
#include "host/environment.h"
#include "host/linux/sys.h"
#include "host/linux/xlib.h"
#include "host/process.h"
#include "host/threads.h"

#include <GL/glx.h>
#include <X11/keysym.h>

namespace odraz {

namespace {

#define ODRAZ_GLX(F)                                                                                         \
    F(glXChooseFBConfig) F(glXGetVisualFromFBConfig) F(glXMakeCurrent) F(glXSwapBuffers) F(glXGetProcAddress)
struct Glx {
    ODRAZ_GLX(ODRAZ_MEMBER)
};

} // namespace

struct WindowState {
    Xlib x;
    Glx glx;
    Display *drawing; // used by the thread that traces and draws
    // Used by the thread that listens, which gets the window's events because the window is made through it
    Display *events;
    Window window;
    Atom closeRequest;
    FilmWindow *film;
    int *leave;
};

namespace {

WindowState theWindow; // one process shows one window

int ignoreError(Display *, XErrorEvent *) { return 0; }

int displayGone(Display *) {
    printError("the display went away");
    sys::exit(1);
}

bool isLeaving(WindowState &w, XEvent &event) {
    if (event.type == ClientMessage) return (Atom)event.xclient.data.l[0] == w.closeRequest;
    if (event.type != KeyPress) return false;
    KeySym key = w.x.XLookupKeysym(&event.xkey, 0);
    if (key == XK_space) __atomic_xor_fetch(&w.film->paused, 1, __ATOMIC_RELAXED);
    return key == XK_Escape || (key == XK_F4 && (event.xkey.state & Mod1Mask));
}

[[gnu::force_align_arg_pointer]] void *listen(void *context) {
    WindowState &w = *(WindowState *)context;
    // Wait for events, and wake up every 20 s to hold off the screen saver
    for (;;) {
        while (w.x.XPending(w.events)) {
            XEvent event;
            w.x.XNextEvent(w.events, &event);
            if (event.type == ConfigureNotify) {
                __atomic_store_n(&w.film->width, event.xconfigure.width, __ATOMIC_RELAXED);
                __atomic_store_n(&w.film->height, event.xconfigure.height, __ATOMIC_RELAXED);
            }
            if (isLeaving(w, event)) {
                __atomic_store_n(w.leave, 1, __ATOMIC_RELAXED);
                // Let the film end by itself if it can, but do not wait long for a slow driver
                sleepFor(80000000);
                sys::exit(0);
            }
        }
        w.x.XResetScreenSaver(w.events);
        w.x.XFlush(w.events);
        sys::waitFor(ConnectionNumber(w.events), sys::kInput, 20000);
    }
}

// Suspends screen savers that support the MIT extension. Without its library, only XResetScreenSaver() above
// holds them off. A display may lack the extension (Xwayland), and Xlib would then print an error, so it is
// queried first.
void suspendScreenSaver(Display *display) {
    struct {
        Bool (*query)(Display *, int *, int *);
        void (*suspend)(Display *, Bool);
    } saver;
    int events, errors;
    if (!loadFunctions("libXss.so.1", "XScreenSaverQueryExtension\0XScreenSaverSuspend\0", (void **)&saver) &&
        saver.query(display, &events, &errors))
        saver.suspend(display, True);
}

void hidePointer(WindowState &w) {
    static const char kNothing[1] = {};
    Pixmap blank = w.x.XCreateBitmapFromData(w.events, w.window, kNothing, 1, 1);
    XColor black = {};
    w.x.XDefineCursor(w.events, w.window,
                      w.x.XCreatePixmapCursor(w.events, blank, blank, &black, &black, 0, 0));
}

bool hasWindowManager(WindowState &w) {
    Atom type, check = w.x.XInternAtom(w.events, "_NET_SUPPORTING_WM_CHECK", False);
    int format;
    unsigned long items = 0, rest;
    unsigned char *data = nullptr;
    w.x.XGetWindowProperty(w.events, DefaultRootWindow(w.events), check, 0, 1, False, AnyPropertyType, &type,
                           &format, &items, &rest, &data);
    if (data) w.x.XFree(data);
    return items > 0;
}

void createWindow(WindowState &w, XVisualInfo *visual, bool fullScreen, int width, int height) {
    Xlib &x = w.x;
    int screen = DefaultScreen(w.events);
    Window root = RootWindow(w.events, screen);
    if (fullScreen) width = DisplayWidth(w.events, screen), height = DisplayHeight(w.events, screen);
    w.film->width = width;
    w.film->height = height;
    XSetWindowAttributes attributes = {};
    attributes.colormap = x.XCreateColormap(w.events, root, visual->visual, AllocNone);
    attributes.event_mask = KeyPressMask | StructureNotifyMask;
    w.window = x.XCreateWindow(w.events, root, 0, 0, (unsigned)width, (unsigned)height, 0, visual->depth,
                               InputOutput, visual->visual,
                               CWColormap | CWBorderPixel | CWBackPixel | CWEventMask, &attributes);
    x.XStoreName(w.events, w.window, FILM_NAME);
    w.closeRequest = x.XInternAtom(w.events, "WM_DELETE_WINDOW", False);
    x.XSetWMProtocols(w.events, w.window, &w.closeRequest, 1);
    if (fullScreen) {
        // Set before mapping, so that the window is never shown at its normal size first
        Atom state = x.XInternAtom(w.events, "_NET_WM_STATE", False);
        Atom full = x.XInternAtom(w.events, "_NET_WM_STATE_FULLSCREEN", False);
        x.XChangeProperty(w.events, w.window, state, 4 /* XA_ATOM */, 32, PropModeReplace,
                          (unsigned char *)&full, 1);
    }
    hidePointer(w);
    x.XMapRaised(w.events, w.window);
    // Without a window manager the program must take the keyboard focus itself, once the window is mapped
    if (!hasWindowManager(w)) {
        XEvent event;
        do x.XNextEvent(w.events, &event);
        while (event.type != MapNotify);
        x.XSetInputFocus(w.events, w.window, RevertToParent, CurrentTime);
    }
    x.XSync(w.events, False);
}

} // namespace

const char *openWindow(FilmWindow &window, bool fullScreen, int width, int height, int *leave) {
    WindowState &w = theWindow;
    window.state = &w;
    w.film = &window;
    w.leave = leave;
    if (loadXlib(w.x)) return "libX11.so.6 is missing: install libx11-6, or use --dump";
    if (loadFunctions("libGL.so.1", ODRAZ_GLX(ODRAZ_NAME), (void **)&w.glx))
        return "libGL.so.1 is missing: install libgl1 and libgl1-mesa-dri, or use --dump";
    w.x.XInitThreads();
    w.drawing = w.x.XOpenDisplay(nullptr);
    w.events = w.x.XOpenDisplay(nullptr);
    if (!w.drawing || !w.events)
        return causeOf(
            "no X display\0, which cannot be opened, or use --dump\0DISPLAY\0\0set DISPLAY, or use --dump",
            nullptr);
    w.x.XSetErrorHandler(ignoreError);
    w.x.XSetIOErrorHandler(displayGone);

    // Choose a format for OpenGL 3.3
    static const int kFormat[] = {GLX_DOUBLEBUFFER, True, GLX_RED_SIZE, 8, GLX_GREEN_SIZE, 8,
                                  GLX_BLUE_SIZE,    8,    None};
    static const int kVersion[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 3, None};
    int count = 0, depth = DefaultDepth(w.drawing, DefaultScreen(w.drawing));
    if (depth < 24) return "the screen has too few colours: set it to 24 bits, or use --dump";
    GLXFBConfig *configs = w.glx.glXChooseFBConfig(w.drawing, DefaultScreen(w.drawing), kFormat, &count);
    // Choose a visual of the screen's own depth: a deeper one has alpha, and compositors would blend it
    XVisualInfo *visual = nullptr;
    int chosen = -1;
    while (++chosen < count) {
        visual = w.glx.glXGetVisualFromFBConfig(w.drawing, configs[chosen]);
        if (visual && visual->depth == depth) break;
    }
    // Make the context and the window, both for the drawing thread
    auto find = [](const char *name) {
        return (void *)theWindow.glx.glXGetProcAddress((const GLubyte *)name);
    };
    auto createContext = (PFNGLXCREATECONTEXTATTRIBSARBPROC)find("glXCreateContextAttribsARB");
    const char *version = nullptr;
    auto wrong = [&] {
        return causeOf("no OpenGL 3.3 on this display" ODRAZ_LOWERS_GL
                       "install libgl1-mesa-dri, or use --dump",
                       version);
    };
    if (chosen >= count || !createContext) return wrong();
    GLXContext context = createContext(w.drawing, configs[chosen], nullptr, True, kVersion);
    if (!context) {
        // Ask an older context for its version, if there is one. Xvfb would crash without a drawable
        context = createContext(w.drawing, configs[chosen], nullptr, True, kVersion + 4);
        w.glx.glXMakeCurrent(w.drawing, DefaultRootWindow(w.drawing), context);
        version = (const char *)((decltype(&::glGetString))find("glGetString"))(GL_VERSION);
        return wrong();
    }
    createWindow(w, visual, fullScreen, width, height);
    suspendScreenSaver(w.events);
    if (!w.glx.glXMakeCurrent(w.drawing, w.window, context) || fillGl(find, window.gl)) return wrong();
    // Swap at the display's vertical sync, so that pictures do not tear and follow its rate
    if (auto setInterval = (PFNGLXSWAPINTERVALSGIPROC)find("glXSwapIntervalSGI")) setInterval(1);
    if (startThread(listen, &w))
        return "no thread to listen for keys: raise the limit on processes (ulimit -u)";
    return nullptr;
}

void leaveContext(FilmWindow &window) {
    WindowState &w = *window.state;
    w.glx.glXMakeCurrent(w.drawing, None, nullptr);
}

void swapBuffers(FilmWindow &window) {
    WindowState &w = *window.state;
    w.glx.glXSwapBuffers(w.drawing, w.window);
}

} // namespace odraz
