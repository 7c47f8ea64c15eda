// Whether patches see backs.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/mesh.h"

namespace odraz {

// Whether some patch sees the back of something: where none does, hemicubes may leave backs out. Looks around
// from 500 patches or so.
bool seesBacks(const Model &model, const Mesh &mesh);

} // namespace odraz
