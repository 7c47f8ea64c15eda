// What this machine has of what the film needs: the first thing to ask a viewer for.
#pragma once

namespace odraz {

// Prints a line each, as soon as it is known: so many processors of that name, memory, whether what was written
// may run, what draws for OpenGL on the display (a window opens for a moment), what draws without one, and
// sound; or what is missing of it and what to do. Exit status: 0 when nothing is missing.
int examine();

} // namespace odraz
