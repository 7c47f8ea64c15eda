// The materials of glTF.
#pragma once

#include "tools/radiosity/read/gltf_file.h"
#include "tools/radiosity/read/mesh_builder.h"

namespace odraz::radiosity {

struct GltfMaterial {
    MeshMaterial mesh;
    // Coordinates of pictures: TEXCOORD_set, u' = uv[0] u + uv[1] v + uv[2], v' = uv[3] u + uv[4] v + uv[5]
    int set = 0;
    std::array<double, 6> uv = {1, 0, 0, 0, 1, 0};
};

// Reads all materials. Adds unused features to `kinds`, and notes on single materials to `notes`. Throws
// Refused.
std::vector<GltfMaterial> readMaterials(GltfFile &file, const std::string &path, NotedKinds &kinds,
                                        std::vector<std::string> &notes);

} // namespace odraz::radiosity
