// Whether patches see backs.
#pragma once

#include "radiosity/model.h"
#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// Whether any patch sees the back of a surface; about 500 patches are checked. If none does, hemicubes need
// not draw backs.
bool seesBacks(const Model &model, const Mesh &mesh);

} // namespace odraz::radiosity
