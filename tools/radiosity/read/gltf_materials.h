// The materials of glTF.
#pragma once

#include "tools/radiosity/read/gltf_file.h"
#include "tools/radiosity/read/mesh_builder.h"

namespace odraz::radiosity {

struct GltfMaterial {
    MeshMaterial mesh;
    // Where its pictures lie: coordinates of a set, TEXCOORD_n, with u' = at[0] u + at[1] v + at[2] and
    // v' = at[3] u + at[4] v + at[5]
    int set = 0;
    std::array<double, 6> at = {1, 0, 0, 0, 1, 0};
};

// What is not used is added to `kinds` and `notes`. Throws Refused.
std::vector<GltfMaterial> readMaterials(GltfFile &file, const std::string &path, NotedKinds &kinds,
                                        std::vector<std::string> &notes);

} // namespace odraz::radiosity
