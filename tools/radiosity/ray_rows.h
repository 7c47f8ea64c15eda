// Hemicubes by rays: what OpenGL draws, each pixel found by a ray of the tracer. OpenGL's time grows with the
// polygons, that of rays hardly: faster from some thousands on.
#pragma once

#include "tools/radiosity/row_finder.h"

namespace odraz {

// Rows by hemicubes of `px` pixels.
RowFinder rowsByRayHemicubes(int px);

// Whether some patch sees the back of something: where none does, hemicubes may leave backs out. Looks around
// from 500 patches at most.
bool seesBacks(const Model &model, const Scene &scene, Workers &workers);

} // namespace odraz
