// The window: when Windows calls us its registers are kept, the display stays awake, pixels are right.
#include "probe.h"

#include "host/window.h"

using namespace odraz;

namespace probe {

namespace {

uint32_t theState, theAnswer, theCalls;
void *theUsual;

// Replaces GetProcAddress, which this program imports: it returns beAware() for SetProcessDpiAwarenessContext
typedef PROBE_WINDOWS void *FindFunction(void *library, const char *name);
void *theUsualFind;
typedef PROBE_WINDOWS int AwareFunction(int64_t);
AwareFunction *theAware;
int64_t theAwareness;
PROBE_WINDOWS int beAware(int64_t context) {
    theAwareness = context;
    return theAware(context);
}
PROBE_WINDOWS void *find(void *library, const char *name) {
    void *found = ((FindFunction *)theUsualFind)(library, name);
    static const char kWanted[] = "SetProcessDpiAwarenessContext";
    for (size_t i = 0; i < sizeof kWanted; ++i)
        if (name[i] != kWanted[i]) return found;
    theAware = (AwareFunction *)found;
    return (void *)beAware;
}

PROBE_WINDOWS uint32_t stayAwake(uint32_t state) {
    theState = state;
    ++theCalls;
    return theAnswer = ((PROBE_WINDOWS uint32_t(*)(uint32_t))theUsual)(state);
}

} // namespace

void shown() {
    auto aware = (PROBE_WINDOWS int (*)())function("user32.dll", "IsProcessDPIAware");
    static FilmWindow film;
    static int leave;
    {
        void **imported;
        __asm__("lea GetProcAddress@GOTPCREL(%%rip), %0" : "=r"(imported));
        Instead state(kernelSlot("SetThreadExecutionState"), (void *)stayAwake);
        theUsual = state.usual;
        theUsualFind = *imported;
        Instead found(imported, (void *)find);
        const char *wrong = openWindow(film, false, 320, 180, &leave);
        check(wrong ? wrong : "a window opens", !wrong);
        if (wrong) return;
        for (int i = 0; i < 5000 && (film.width != 320 || film.height != 180); ++i) Sleep(2);
    }
    check("it has the width given", film.width == 320, film.width);
    check("... and the height", film.height == 180, film.height);
    check("display and machine are asked to stay awake, once, until it ends",
          theState == 0x80000003 && theCalls == 1, theState);
    check("... which is granted", theAnswer != 0);
    check("pixels are the display's", aware() && theAwareness == -4, theAwareness);
    check("OpenGL reports its version", film.gl.glGetString(GL_VERSION) != nullptr);

    auto findWindow =
        (PROBE_WINDOWS HANDLE(*)(const char *, const char *))function("user32.dll", "FindWindowA");
    auto get = (PROBE_WINDOWS void *(*)(HANDLE, int))function("user32.dll", "GetWindowLongPtrA");
    HANDLE window = findWindow("odraz", nullptr);
    void *receive = window ? get(window, -4 /* GWLP_WNDPROC */) : nullptr;
    check("what Windows calls is found", receive);
    if (!receive) return;

    static const struct {
        const char *what;
        uint64_t message, a, b, result;
    } kMessages[] = {
        {"a size", 5, 0, 123 | 77 << 16, 0},
        {"a cursor within", 32, 0, 1, 1},
        {"the screen saver", 0x112, 0xf140, 0, 0},
        {"a display to be switched off", 0x112, 0xf170, 2, 0},
        {"a question for the title's length", 14, 0, 0, 5},
        {"nothing", 0, 0, 0, 0},
    };
    for (auto &m : kMessages) {
        Kept after;
        uint64_t arguments[4] = {(uint64_t)window, m.message, m.a, m.b};
        setMxcsr(kSpoilt & ~0x40u); // Windows's own state is kept as well
        callAsWindows(receive, arguments, after);
        uint32_t rounding = mxcsr();
        setMxcsr(kUsual);
        check(m.what, after.result == m.result, (int64_t)after.result);
        check("... is answered with the registers kept", keptByWindows(after), after.stack);
        check("... and the rounding of floats", rounding == (kSpoilt & ~0x40u), rounding);
    }
    check("the size is taken over", film.width == 123 && film.height == 77, film.width);
}

} // namespace probe
