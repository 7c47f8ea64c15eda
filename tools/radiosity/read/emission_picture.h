// Pictures of emission (map_Ke): triangles are divided until each part emits evenly, about as the picture
// shows it. Parts that emit alike share a material, which has the name of the whole.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// Divides the triangles whose material has MeshMaterial::glow. Adds a note for a picture that cannot be read;
// its materials emit Ke.
void divideByEmission(Mesh &mesh, std::vector<std::string> &notes);

} // namespace odraz::radiosity
