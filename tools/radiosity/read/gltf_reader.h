// Reads glTF 2.0 (.gltf and .glb). mesh.h describes the functions under readModel() and
// readMaterialsAgain().
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

Mesh readGltf(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);
std::vector<MeshMaterial> readGltfMaterials(const std::string &path, const MaterialNames &names,
                                            const std::vector<MaterialChange> &changes,
                                            std::vector<std::string> &notes);

} // namespace odraz::radiosity
