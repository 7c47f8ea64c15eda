// What the engine can do and the film does not need: triangles, glowing facets, hemicubes in several turns.
#pragma once

namespace odraz {

// Whether it may be needed. The engine says yes, for tools, tests and odraz-debug. The film's main.cpp says
// no, so that code behind this constant leaves the film when it is optimised as a whole.
extern const bool kForTools;

} // namespace odraz
