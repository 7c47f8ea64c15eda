// Opens windows by GLFW, for programs that link it or define its functions.
#pragma once

#include "base/gl.h"
#include "host/environment.h"
#include "host/library.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace odraz {

// Opens a window with a core context of OpenGL 3.3, makes it current, and fills the table. Returns null, or a
// line that says what is missing and what to do.
static inline const char *openGlfwWindow(GLFWwindow *&window, int width, int height, const char *title,
                                         Gl &gl) {
    if (!glfwInit())
        return causeOf("no X display\0, which cannot be opened\0DISPLAY\0\0set DISPLAY", nullptr);
    auto open = [&](int major, int minor, int profile) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        glfwWindowHint(GLFW_OPENGL_PROFILE, profile);
        window = glfwCreateWindow(width, height, title, nullptr, nullptr);
        if (window) glfwMakeContextCurrent(window);
        return window && !fillGl([](const char *name) { return (void *)glfwGetProcAddress(name); }, gl);
    };
    if (open(3, 3, GLFW_OPENGL_CORE_PROFILE)) return nullptr;
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    const char *older =
                   open(1, 0, GLFW_OPENGL_ANY_PROFILE) ? (const char *)gl.glGetString(GL_VERSION) : nullptr,
               *line =
                   causeOf("no OpenGL 3.3 on this display" ODRAZ_LOWERS_GL "install libgl1-mesa-dri", older);
    glfwTerminate();
    return line;
}

} // namespace odraz
