// The viewer's window, with a context of OpenGL 3.3. The film's picture is scaled to it with its aspect kept.
#pragma once

#include "base/gl.h"

#include <stdint.h>

namespace odraz {

struct WindowState; // the system's own

struct FilmWindow {
    WindowState *state;
    Gl gl;             // current on the thread that opened the window
    int width, height; // as last told by the system, on a thread of its own
    GLuint picture, framebuffer;
    int64_t loadingShown; // when, in nanoseconds
};

// Opens a window, full screen or of width x height, and makes its context current. ESC, Alt-F4 and the close
// button set *leave from a thread of their own, whatever the others do; a tenth of a second later at most the
// process ends, with status 0. Returns null, or a line that says what is missing and what to do.
const char *openWindow(FilmWindow &window, bool fullScreen, int width, int height, int *leave);

// Lets go of the context, so that this thread can have another.
void leaveContext(FilmWindow &window);

// Shows what was drawn.
void swapBuffers(FilmWindow &window);

// Shows a picture of width x height RGBA bytes, top row first. The size stays the same from call to call.
void present(FilmWindow &window, const uint8_t *rgba, int width, int height);

// Shows how far loading is, 0 .. 1; `window` is a FilmWindow. Called often, it draws a few dozen times a
// second.
void showLoading(float done, void *window);

} // namespace odraz
