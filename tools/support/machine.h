// OpenGL without a display, and threads, on which tools run the engine.
#pragma once

#include "base/gl.h"
#include "base/parallel.h"

namespace odraz {

// A flag that is never set, for Workers::abort and other flags that stop work early.
inline constexpr int kNever = 0;

// Returns workers with a thread for every processor. The threads end with the process. Throws
// std::runtime_error with a line that names the cause.
Workers allProcessors();

// Opens OpenGL without a display, current on this thread. Throws like allProcessors().
Gl openGl();

} // namespace odraz
