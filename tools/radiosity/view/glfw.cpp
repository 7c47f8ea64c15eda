#include "tools/radiosity/view/window.h"

#include "host/library.h"

// The functions that the window calls. This file does not include <GLFW/glfw3.h>, which declares them.
// clang-format off
#define ODRAZ_GLFW(F) \
    F(glfwCreateWindow) F(glfwDestroyWindow) F(glfwGetCursorPos) F(glfwGetFramebufferSize) \
    F(glfwGetKey) F(glfwGetProcAddress) F(glfwGetTime) F(glfwGetWindowSize) F(glfwGetWindowUserPointer) \
    F(glfwInit) F(glfwMakeContextCurrent) F(glfwPollEvents) F(glfwPostEmptyEvent) \
    F(glfwSetCursorPosCallback) F(glfwSetInputMode) F(glfwSetKeyCallback) F(glfwSetMouseButtonCallback) \
    F(glfwSetScrollCallback) F(glfwSetWindowRefreshCallback) F(glfwSetWindowShouldClose) \
    F(glfwSetWindowTitle) F(glfwSetWindowUserPointer) F(glfwSwapBuffers) F(glfwSwapInterval) \
    F(glfwTerminate) F(glfwWaitEventsTimeout) F(glfwWindowHint) F(glfwWindowShouldClose)
// clang-format on

// Defines a function that jumps to the library's function and leaves the parameters in place.
#define ODRAZ_JUMP(name)                                                                                     \
    extern "C" {                                                                                             \
    void *odraz_##name;                                                                                      \
    [[gnu::naked]] void name() { __asm__("jmp *odraz_" #name "(%rip)"); }                                    \
    }
ODRAZ_GLFW(ODRAZ_JUMP)

const char *odraz::radiosity::openGlfw() {
#define ODRAZ_PLACE(name) &odraz_##name,
    static void **const places[] = {ODRAZ_GLFW(ODRAZ_PLACE)};
    void *found[sizeof places / sizeof *places];
    if (loadFunctions("libglfw.so.3", ODRAZ_GLFW(ODRAZ_NAME), found))
        return "a window needs GLFW: install libglfw3";
    for (int i = 0; i < (int)(sizeof places / sizeof *places); ++i) *places[i] = found[i];
    return nullptr;
}
