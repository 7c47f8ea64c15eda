// Materials of Wavefront OBJ.
#pragma once

#include "tools/radiosity/mesh.h"

// A file's name as some other program wrote it, with backslashes, another system's folders or other capitals:
// the file that is meant, beside a folder (which ends with a slash, or is empty). Where there is none, what
// the name says.
std::string findFile(const std::string &folder, std::string name);

// Of all libraries, as they stand behind mtllib: names with blanks, or several. Notes tell what cannot be
// read. Throws ModelError where a number is none that a material can have.
std::vector<MeshMaterial> readMaterials(const std::string &model, const std::vector<std::string> &libraries,
                                        std::vector<std::string> &notes);
