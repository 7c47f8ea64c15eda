// The viewer's window, on Windows's own window manager and WGL.
#include "host/window.h"

#include "film.h"
#include "host/library.h"
#include "host/process.h"
#include "host/windows/calls.h"
#include "host/windows/context.h"

namespace odraz {

using namespace windows;

struct WindowState {
    FilmWindow *film;
    int *leave;
    Surface surface;
};

namespace {

WindowState theWindow = {}; // one process shows one window

constexpr uint32_t kSize = 5, kClose = 16, kSetCursor = 32, kKeyDown = 256, kCommand = 0x112,
                   kVisible = 0x10000000, kPopUp = 0x80000000, kOverlapped = 0xcf0000, kScreenSaver = 0xf140,
                   kMonitorPower = 0xf170;
// Windows's numbers of keys
constexpr uint16_t kKeys[kActions] = {32, 'M', 'L', 37, 39, 'F', 27};
constexpr int kControl = 17, kLeftMeta = 91, kRightMeta = 92;

// Switches between full screen and a window of half its size.
void switchScreen(HANDLE window) {
    bool full = theWindow.surface.style == (kPopUp | kVisible);
    theWindow.surface.style = (full ? kOverlapped : kPopUp) | kVisible;
    SetWindowLongA(window, -16 /* GWL_STYLE */, (int)theWindow.surface.style);
    SetWindowPos(window, nullptr, 0, 0, GetSystemMetrics(0) >> full, GetSystemMetrics(1) >> full,
                 0x20 /* SWP_FRAMECHANGED */);
}

// Windows calls this function, in its own convention.
[[gnu::ms_abi, gnu::force_align_arg_pointer]] int64_t receive(HANDLE window, uint32_t message, uint64_t a,
                                                              uint64_t b) {
    FilmWindow &film = *theWindow.film;
    if (message == kSize) {
        __atomic_store_n(&film.width, (int)(b & 0xffff), __ATOMIC_RELAXED);
        __atomic_store_n(&film.height, (int)(b >> 16 & 0xffff), __ATOMIC_RELAXED);
    }
    int action = kActions;
    // Keys with Alt have another message. Bit 30: the key was down before
    if (message == kKeyDown && !(b >> 30 & 1) &&
        (GetKeyState(kControl) | GetKeyState(kLeftMeta) | GetKeyState(kRightMeta)) >= 0)
        action = press(film, kKeys, a);
    if (action == kFullScreen) switchScreen(window);
    // The system turns Alt-F4 and the close button into the same message
    if (message == kClose || action == kEnd) leave(film, theWindow.leave);
    // Keep display and machine awake while the film moves, and this thread lives
    bool moves = !isOn(film, kPause);
    SetThreadExecutionState(moves ? 0x80000003 : 0x80000000);
    __atomic_add_fetch(&film.events, 1, __ATOMIC_RELAXED);
    if (message == kSetCursor && (b & 0xffff) == 1 /* within */) {
        SetCursor(nullptr);
        return 1;
    }
    if (message == kCommand && moves && ((a & 0xfff0) == kScreenSaver || (a & 0xfff0) == kMonitorPower))
        return 0;
    return DefWindowProcA(window, message, a, b);
}

// Asks the desktop not to scale the window. Before Windows 10 this works on the first display only.
void beAware() {
    auto aware = (__attribute__((ms_abi)) int (*)(int64_t))GetProcAddress(LoadLibraryA("user32.dll"),
                                                                          "SetProcessDpiAwarenessContext");
    if (!aware || !aware(-4 /* DPI_AWARENESS_CONTEXT_PER_MONITOR_AWARE_V2 */)) SetProcessDPIAware();
}

} // namespace

const char *openWindow(FilmWindow &window, bool fullScreen, int width, int height, int *leave) {
    static const char kNoGl[] =
        "no OpenGL 3.3 on this display: install the graphics card's driver, or use --dump";
    WindowState &w = theWindow;
    window.state = &w;
    w.film = &window;
    w.leave = leave;
    if (openGlLibraries()) return kNoGl;
    beAware();
    // Let Sleep() be exact to 1 ms; the default is a sixty-fourth of a second
    if (!loadFunctions("winmm.dll", ODRAZ_WINMM(ODRAZ_NAME), odrazFunctions.winmm)) timeBeginPeriod(1);
    WindowClass kind = {};
    kind.style = 32; // CS_OWNDC
    kind.receive = (void *)receive;
    kind.name = FILM_NAME;
    RegisterClassA(&kind);
    Surface &s = w.surface;
    if (fullScreen) {
        s = {kind.name, kPopUp | kVisible, 0, 0, GetSystemMetrics(0), GetSystemMetrics(1)};
    } else {
        int area[4] = {0, 0, width, height};
        AdjustWindowRect(area, kOverlapped, 0);
        s = {kind.name, kOverlapped | kVisible, 40, 40, area[2] - area[0], area[3] - area[1]};
    }
    if (const char *line = openSurface(s)) return line;
    if (!s.dc) return "no display: log in to one, or use --dump";
    SetForegroundWindow(s.window);
    if (createContext(s.dc, window.gl)) return kNoGl;
    // Swap at the display's vertical sync, so that pictures do not tear and follow its rate
    auto setInterval = (__attribute__((ms_abi)) int (*)(int))glFunction("wglSwapIntervalEXT");
    if (setInterval) setInterval(1);
    return nullptr;
}

void leaveContext(FilmWindow &) { wglMakeCurrent(nullptr, nullptr); }

void swapBuffers(FilmWindow &window) { SwapBuffers(window.state->surface.dc); }

} // namespace odraz
