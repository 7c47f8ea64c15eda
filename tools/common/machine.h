// What tools run the engine on: OpenGL without a display, and threads.
#pragma once

#include "base/gl.h"
#include "base/parallel.h"

namespace odraz {

// For Workers::abort and what else is watched for an interruption: there is none.
inline constexpr int kNever = 0;

// A thread for every processor; they end with the process. Throws std::runtime_error that tells what is
// missing.
Workers allProcessors();

// OpenGL without a display, current on this thread. Throws likewise.
Gl openGl();

} // namespace odraz
