// The window of odraz-debug, and a picture in it.
#pragma once

#include "base/gl.h"
#include "intro.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace odraz::maker {

struct Screen {
    GLFWwindow *window, *hidden; // the latter's context is for what is loaded in the background
    Gl gl;
    int width, height;
    // Makes the hidden window's context current, or none: for the thread that loads
    void hiddenCurrent(bool on) const { glfwMakeContextCurrent(on ? hidden : nullptr); }
    GLuint texture, framebuffer;
};

// Opens it and makes its context current. Returns null, or what is missing. `visible`: whether it is shown.
const char *open(Screen &s, int width, int height, bool visible);

// Makes what show() needs.
void prepare(Screen &s);
void show(Screen &s, const Picture &p);

} // namespace odraz::maker
