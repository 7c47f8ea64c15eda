// Checks what this machine has of what the film needs. Its output is the first thing to ask a viewer for.
#pragma once

namespace odraz {

// Prints a line for each of these as soon as it is known: processors, memory, whether code may be made and
// run, OpenGL on the display (a window opens for a moment) and without one, and sound. Each line says what is
// there, or what is missing and what to do. Exit status: 0 when nothing is missing.
int examine();

} // namespace odraz
