// Keys and the mouse of a GLFW window, led to the panel.
#pragma once

#include "maker/panel/panel.h"

struct GLFWwindow;

namespace odraz::maker {

// Sets the window's callbacks. Those for keys and the mouse that were there are called too: for all keys that
// are not the panel's, and always for the mouse. The panel must outlive the window.
void listen(Panel &panel, GLFWwindow *window);

} // namespace odraz::maker
