// Reads Wavefront OBJ and its materials. mesh.h describes the functions under readModel() and
// readMaterialsAgain().
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);
std::vector<MeshMaterial> readObjMaterials(const std::string &path, const MaterialNames &names,
                                           const std::vector<MaterialChange> &changes,
                                           std::vector<std::string> &notes);

} // namespace odraz::radiosity
