// GLFW, loaded when a window is opened, so that all other commands run without it.
#pragma once

namespace odraz::radiosity {

// Makes the functions of <GLFW/glfw3.h> callable. Returns null, or a line with the error and its remedy.
const char *openGlfw();

} // namespace odraz::radiosity
