// The window of odraz-debug, and a picture in it.
#pragma once

#include "host/glfw.h"
#include "intro.h"

namespace odraz::maker {

struct Screen {
    GLFWwindow *window, *hidden; // the context of `hidden` is for the thread that loads
    Gl gl;
    int width, height;
    // Makes the hidden window's context current on the calling thread; false: no context
    void useHidden(bool on) const { glfwMakeContextCurrent(on ? hidden : nullptr); }
    GLuint texture, framebuffer;
};

// Opens the window and makes its context current. Returns null, or an error line.
const char *open(Screen &s, int width, int height);
void show(Screen &s, const Picture &p);

} // namespace odraz::maker
