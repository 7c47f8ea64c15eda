// The viewer's window, with a context of OpenGL 3.3. The film's picture is scaled to it with its aspect kept.
#pragma once

#include "base/gl.h"

#include <stdint.h>

namespace odraz {

struct WindowState; // the system's own

struct FilmWindow {
    WindowState *state;
    Gl gl;             // current on the thread that opened the window
    int width, height; // as the system last reported it; another thread sets it
    int stands;        // 1: the film does, from one press of the space bar to the next; likewise
    GLuint picture, framebuffer;
    int64_t loadingShown; // when loading was last shown, in nanoseconds()
};

// Opens a window, full screen or of width x height, and makes its context current. ESC, Alt-F4 and the
// close button set *leave, on another thread, whatever the rest of the program is doing. The process ends
// with status 0 at most a tenth of a second later. Returns null, or a line that says what is missing and
// what to do.
const char *openWindow(FilmWindow &window, bool fullScreen, int width, int height, int *leave);

// Releases the context from this thread, so that the thread can use another one.
void leaveContext(FilmWindow &window);

// Shows what was drawn.
void swapBuffers(FilmWindow &window);

// The largest rectangle of an aspect in the middle of the window, where pictures of width x height are shown.
struct Area {
    int x, y, width, height;
};
Area areaOf(const FilmWindow &window, int width, int height);

// Shows a picture of width x height RGBA bytes, top row first. The size stays the same from call to call.
void present(FilmWindow &window, const uint8_t *rgba, int width, int height);

// Shows how far loading is, 0 .. 1; `window` is a FilmWindow. It may be called often: it draws at most 30
// times a second, and at the end.
void showLoading(float done, void *window);

} // namespace odraz
