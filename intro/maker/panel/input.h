// Passes keys and the mouse of a GLFW window to the panel.
#pragma once

#include "maker/panel/panel.h"

struct GLFWwindow;

namespace odraz::maker {

// Sets the window's callbacks. The previous callback for keys gets all keys that are not the panel's. The
// panel must outlive the window.
void listen(Panel &panel, GLFWwindow *window);

} // namespace odraz::maker
