// Checks whether this machine has what the film needs. If a viewer reports a problem, ask for this output
// first.
#pragma once

namespace odraz {

// Prints a line for each of these as soon as it is known: processors, memory, whether code may be made and
// run, OpenGL on the display (a window opens for a moment) and without one, and sound. Each line has what
// was found, or what is missing and what to do. Exit status: 0 when nothing is missing.
int examine();

} // namespace odraz
