// What the tools run the engine on: OpenGL without a display, and threads.
#pragma once

#include "base/gl.h"
#include "base/parallel.h"

namespace odraz {

// For Workers::abort and other flags that stop work early; it is never set.
inline constexpr int kNever = 0;

// A thread for every processor; they end with the process. Throws std::runtime_error with what is
// missing.
Workers allProcessors();

// OpenGL without a display, current on this thread. Throws like allProcessors().
Gl openGl();

} // namespace odraz
