// Reads Wavefront OBJ and its materials: a format of readModel() (mesh.h), which describes the functions.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);
std::vector<MeshMaterial> readObjMaterials(const std::string &path, const MaterialNames &names,
                                           const std::vector<MaterialChange> &changes,
                                           std::vector<std::string> &notes);

} // namespace odraz::radiosity
