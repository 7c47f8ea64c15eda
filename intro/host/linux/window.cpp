// The viewer's window, on X11 and GLX.
#include "host/window.h"

#include "film.h"
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
    Atom closeRequest, state, full;
    FilmWindow *film;
    int *leave;
    unsigned held; // the code of the key that went down last, until it goes up
    bool opened;   // whether the window was opened on the full screen and has not left it yet
    bool asked;    // whether the window manager was asked to switch
    void (*suspend)(Display *, Bool); // suspends screen savers that support the MIT extension; may be null
};

namespace {

WindowState theWindow; // one process shows one window

int ignoreError(Display *, XErrorEvent *) { return 0; }

int displayGone(Display *) {
    printError("the display went away");
    sys::exit(1);
}

// Asks the window manager to switch between full screen and window. `event`: the window's, which is changed.
void switchScreen(WindowState &w, XEvent &event) {
    event.type = ClientMessage;
    event.xclient.message_type = w.state;
    event.xclient.format = 32;
    event.xclient.data.l[0] = 2; // toggle
    event.xclient.data.l[1] = (long)w.full;
    event.xclient.data.l[2] = 0;
    w.x.XSendEvent(w.events, DefaultRootWindow(w.events), False,
                   SubstructureRedirectMask | SubstructureNotifyMask, &event);
    w.asked = true;
}

// Does what an event does. Returns whether the viewer leaves.
bool handle(WindowState &w, XEvent &event) {
    static const uint16_t kKeys[kActions] = {XK_space, XK_m, XK_l, XK_Left, XK_Right, XK_f, XK_Escape};
    if (event.type == ClientMessage) return (Atom)event.xclient.data.l[0] == w.closeRequest;
    // The window manager has taken the window from the full screen, but it would stay as large
    if (event.type == PropertyNotify && event.xproperty.atom == w.state && w.asked && w.opened) {
        w.x.XResizeWindow(w.events, w.window, (unsigned)w.film->width / 2, (unsigned)w.film->height / 2);
        w.opened = false;
    }
    unsigned code = event.xkey.keycode;
    // If another window has the focus, no event says that the key goes up
    if (event.type == FocusOut || (event.type == KeyRelease && code == w.held)) w.held = 0;
    if (event.type != KeyPress || code == w.held) return false;
    w.held = code;
    KeySym key = w.x.XLookupKeysym(&event.xkey, 0);
    if (event.xkey.state & (ControlMask | Mod1Mask | Mod4Mask))
        return key == XK_F4 && (event.xkey.state & Mod1Mask);
    int action = press(*w.film, kKeys, key);
    if (action == kFullScreen) switchScreen(w, event);
    return action == kEnd;
}

[[gnu::force_align_arg_pointer]] void *listen(void *context) {
    WindowState &w = *(WindowState *)context;
    // Wait for events, and wake up every 20 s to hold off the screen saver while the film moves
    for (bool moved = false;;) {
        while (w.x.XPending(w.events)) {
            XEvent event;
            w.x.XNextEvent(w.events, &event);
            if (event.type == ConfigureNotify) {
                __atomic_store_n(&w.film->width, event.xconfigure.width, __ATOMIC_RELAXED);
                __atomic_store_n(&w.film->height, event.xconfigure.height, __ATOMIC_RELAXED);
            }
            // Without a window manager the program must take the keyboard focus itself
            if (event.type == MapNotify) w.x.XSetInputFocus(w.events, w.window, RevertToParent, CurrentTime);
            if (handle(w, event)) leave(*w.film, w.leave);
            __atomic_add_fetch(&w.film->events, 1, __ATOMIC_RELAXED);
        }
        bool moves = !isOn(*w.film, kPause);
        if (moves != moved && w.suspend) w.suspend(w.events, moves);
        moved = moves;
        if (moves) w.x.XResetScreenSaver(w.events);
        w.x.XFlush(w.events);
        sys::waitFor(ConnectionNumber(w.events), sys::kInput, 20000);
    }
}

// Finds suspend(). Without it, only XResetScreenSaver() above holds off screen savers. A display may lack the
// extension (Xwayland), and Xlib would then print an error, so it is queried first.
void findScreenSaver(WindowState &w) {
    struct {
        Bool (*query)(Display *, int *, int *);
        void (*suspend)(Display *, Bool);
    } saver;
    int events, errors;
    if (!loadFunctions("libXss.so.1", "XScreenSaverQueryExtension\0XScreenSaverSuspend\0", (void **)&saver) &&
        saver.query(w.events, &events, &errors))
        w.suspend = saver.suspend;
}

void hidePointer(WindowState &w) {
    static const char kNothing[1] = {};
    Pixmap blank = w.x.XCreateBitmapFromData(w.events, w.window, kNothing, 1, 1);
    XColor black = {};
    w.x.XDefineCursor(w.events, w.window,
                      w.x.XCreatePixmapCursor(w.events, blank, blank, &black, &black, 0, 0));
}

// As Xinerama describes it.
struct Monitor {
    int number;
    short x, y, width, height;
};

// The primary monitor; the whole screen if monitors are not known.
Monitor primaryMonitor(WindowState &w) {
    Monitor *(*query)(Display *, int *), *found = nullptr;
    int count = 0, screen = DefaultScreen(w.events);
    if (!loadFunctions("libXinerama.so.1", "XineramaQueryScreens\0", (void **)&query))
        found = query(w.events, &count);
    if (count) return *found;
    return {0, 0, 0, (short)DisplayWidth(w.events, screen), (short)DisplayHeight(w.events, screen)};
}

void createWindow(WindowState &w, XVisualInfo *visual, bool fullScreen, int width, int height) {
    Xlib &x = w.x;
    Window root = DefaultRootWindow(w.events);
    Monitor at = {0, 0, 0, (short)width, (short)height};
    if (fullScreen) at = primaryMonitor(w);
    w.film->width = at.width;
    w.film->height = at.height;
    XSetWindowAttributes attributes = {};
    attributes.colormap = x.XCreateColormap(w.events, root, visual->visual, AllocNone);
    attributes.event_mask = KeyPressMask | KeyReleaseMask | FocusChangeMask | ExposureMask |
                            StructureNotifyMask | PropertyChangeMask;
    w.window = x.XCreateWindow(w.events, root, at.x, at.y, (unsigned)at.width, (unsigned)at.height, 0,
                               visual->depth, InputOutput, visual->visual,
                               CWColormap | CWBorderPixel | CWBackPixel | CWEventMask, &attributes);
    static const char kClass[] = FILM_NAME "\0" FILM_NAME;
    x.XStoreName(w.events, w.window, kClass);
    x.XChangeProperty(w.events, w.window, 67 /* XA_WM_CLASS */, 31 /* XA_STRING */, 8, PropModeReplace,
                      (const unsigned char *)kClass, sizeof kClass);
    w.closeRequest = x.XInternAtom(w.events, "WM_DELETE_WINDOW", False);
    x.XSetWMProtocols(w.events, w.window, &w.closeRequest, 1);
    w.state = x.XInternAtom(w.events, "_NET_WM_STATE", False);
    w.full = x.XInternAtom(w.events, "_NET_WM_STATE_FULLSCREEN", False);
    w.opened = fullScreen;
    // Set before mapping, so that the window is never shown at its normal size first
    if (fullScreen)
        x.XChangeProperty(w.events, w.window, w.state, 4 /* XA_ATOM */, 32, PropModeReplace,
                          (unsigned char *)&w.full, 1);
    x.XkbSetDetectableAutoRepeat(w.events, True, nullptr); // or a held key would seem to go up and down
    hidePointer(w);
    x.XMapRaised(w.events, w.window);
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
    findScreenSaver(w);
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
