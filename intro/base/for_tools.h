// What the engine can do and the film does not need: triangles, glowing facets, hemicubes in several turns.
#pragma once

namespace odraz {

// True in the engine, for tools, tests and odraz-debug. The film's main.cpp defines it as false, so that
// link-time optimisation removes the code that depends on it.
extern const bool kForTools;

} // namespace odraz
