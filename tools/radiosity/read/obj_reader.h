// Reads Wavefront OBJ and its materials, as readModel() in mesh.h describes.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);

} // namespace odraz::radiosity
