// Reads materials of Wavefront OBJ.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// Finds a file whose name comes from another program: with backslashes, folders of another system, or other
// capitals. Searches in `folder`, which ends with a slash or is empty. If there is no such file, returns
// folder and name joined.
std::string findFile(const std::string &folder, std::string name);

// Reads all libraries. Each is the text after an mtllib: one name, perhaps with blanks, or several names.
// Adds a note for each library that cannot be read. Throws ModelError if a number is out of range for a
// material.
std::vector<MeshMaterial> readMaterials(const std::string &model, const std::vector<std::string> &libraries,
                                        std::vector<std::string> &notes);

} // namespace odraz::radiosity
