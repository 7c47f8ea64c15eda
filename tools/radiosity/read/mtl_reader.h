// Reads the materials of Wavefront OBJ.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// The folder in a path, with its slash; empty if there is none.
std::string folderOf(const std::string &path);

// Finds a file that another program named: with backslashes or folders of another system, in another case, or
// in Unicode's other form (composed or decomposed, as macOS stores names).
// Searches `folder`, which ends with a slash or is empty. Returns folder + name if there is no such file.
std::string findFile(const std::string &folder, std::string name);

// Reads all libraries. Each is the text after an mtllib: one name, which may have blanks, or several names.
// Adds a note for each library that cannot be read. Throws ModelError if a number is out of range.
std::vector<MeshMaterial> readMaterials(const std::string &model, const std::vector<std::string> &libraries,
                                        std::vector<std::string> &notes);

} // namespace odraz::radiosity
