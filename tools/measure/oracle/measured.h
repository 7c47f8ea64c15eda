// Generated models as meshes, for measuring radiosity.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::measure {

// A model of generateObj(), written to a file and read back. The kind "cave" is a hollow of
// triangles, no two of them in one plane, some of which emit light. Throws std::runtime_error.
radiosity::Mesh generatedMesh(const std::string &kind, double area);

} // namespace odraz::measure
