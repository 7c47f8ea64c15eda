// The readers of the formats, as readModel() in mesh.h describes.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// glTF 2.0 (.gltf and .glb).
Mesh readGltf(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);
// Wavefront OBJ and its materials.
Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);

} // namespace odraz::radiosity
