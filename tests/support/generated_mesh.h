// Generated models as meshes, for measurements of radiosity.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::measure {

// Writes a model of generateObj() to a file and reads it. The kind "cave" is a hollow of triangles, no two of
// them in one plane; some emit light. Throws std::runtime_error.
radiosity::Mesh generatedMesh(const std::string &kind, double area);

} // namespace odraz::measure
