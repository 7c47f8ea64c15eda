// --doctor: checks whether this machine has all that the film needs. Ask a viewer with a problem to run it.
#pragma once

namespace odraz {

// Prints a line for each of these as soon as it is known: processors, memory, permission to run generated
// code, OpenGL on the display (a window opens for a moment) and without one, and sound. Each line says what
// was found, or what is missing and what to do. Returns an exit status: 0 if nothing is missing.
int examine();

} // namespace odraz
