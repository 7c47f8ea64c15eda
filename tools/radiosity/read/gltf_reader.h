// Reads glTF 2.0 (.gltf and .glb), as readModel() in mesh.h describes.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

Mesh readGltf(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);

} // namespace odraz::radiosity
