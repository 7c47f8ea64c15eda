// Passes keys and mouse events of a GLFW window to the panel.
#pragma once

#include "maker/panel/panel.h"

struct GLFWwindow;

namespace odraz::maker {

// Sets the window's callbacks; the panel must outlive it. The previous callback gets keys of no action.
void listen(Panel &panel, GLFWwindow *window);

} // namespace odraz::maker
