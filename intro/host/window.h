// The viewer's window, with a context of OpenGL 3.3. Pictures are scaled to it, and keep their aspect.
#pragma once

#include "base/gl.h"

#include <stdint.h>

namespace odraz {

// What keys do: space, M, L, left and right arrow, F, ESC.
enum Action { kPause, kMute, kLoop, kBack, kAhead, kFullScreen, kEnd, kActions };

struct WindowState; // the system's own

struct FilmWindow {
    WindowState *state;
    Gl gl;                       // current on the thread that opened the window
    int width, height;           // the last size that the system reported; another thread sets it
    int presses[kAhead + 1];     // how often these keys were pressed; another thread counts
    unsigned events;             // number of the window's events: after one it may have to be drawn again
    GLuint picture, framebuffer; // 0 until the first picture
    bool stats;                  // --stats: leaving before the first picture prints a line
    int64_t loadingShown;        // when loading was last shown, in nanoseconds()
};

// Whether this key is switched on: kPause, kMute or kLoop.
inline bool isOn(const FilmWindow &window, Action key) {
    return __atomic_load_n(&window.presses[key], __ATOMIC_RELAXED) & 1;
}

// Does what a key does that went down, without Ctrl, Alt or Meta, and returns it; kFullScreen and kEnd are
// left to the system's window. `keys`: the system's number of each key.
int press(FilmWindow &window, const uint16_t keys[kActions], uint64_t key);

// The viewer leaves: sets *left, and ends the process a little later if the film has not ended by itself.
[[noreturn]] void leave(const FilmWindow &window, int *left);

// Opens a window, full screen or of width x height pixels, and makes its context current. ESC, Alt-F4 and the
// close button set *leave, on another thread, even while this one is busy. The process ends with status 0 at
// most a tenth of a second later. Returns null, or a line that says what is missing and what to do.
const char *openWindow(FilmWindow &window, bool fullScreen, int width, int height, int *leave);

// Releases the context from this thread, so that the thread can use another context.
void leaveContext(FilmWindow &window);

// Shows the back buffer, at the display's next vertical sync.
void swapBuffers(FilmWindow &window);

// Where the window shows a picture of width x height: the largest rectangle of this aspect, in the middle.
struct Viewport {
    int x, y, width, height;
};
Viewport viewportOf(const FilmWindow &window, int width, int height);

// Shows a picture of width x height RGBA pixels, top row first, or the last one again if it is null. All
// calls must have the same size. While the film is paused, two bars stand in the lower left corner.
void present(FilmWindow &window, const uint8_t *rgba, int width, int height);

// Shows the progress of loading, 0 .. 1; `window` is a FilmWindow. It may be called often: it draws at most
// 30 times a second, and at the end.
void showLoading(float done, void *window);

} // namespace odraz
