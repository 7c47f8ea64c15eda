// Whether patches see backs.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// Whether some patch sees the back of a surface. If none does, hemicubes need not draw backs. Checks about
// 500 patches.
bool seesBacks(const Model &model, const Mesh &mesh);

} // namespace odraz::radiosity
