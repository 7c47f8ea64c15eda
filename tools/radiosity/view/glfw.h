// GLFW, opened by name for a window, so that all other commands run where it is not installed.
#pragma once

namespace odraz::radiosity {

// Makes the functions of <GLFW/glfw3.h> callable. Returns null, or a line that says what is missing and what
// to do.
const char *openGlfw();

} // namespace odraz::radiosity
