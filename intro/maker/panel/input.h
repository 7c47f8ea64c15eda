// Passes keys and mouse events of a GLFW window to the panel.
#pragma once

#include "maker/panel/panel.h"

struct GLFWwindow;

namespace odraz::maker {

// Sets the window's callbacks. Keys that are not the panel's go to the previous callback for keys. The panel
// must outlive the window.
void listen(Panel &panel, GLFWwindow *window);

} // namespace odraz::maker
