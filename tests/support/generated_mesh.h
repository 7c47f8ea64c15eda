// Generated models as meshes, for tests of radiosity.
#pragma once

#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/generate/generate.h"
#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// Writes a model of generateObj() to a file and reads it.
inline Mesh generatedMesh(const std::string &kind) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "model.mtl", generateMtl());
    common::writeWhole(folder / "model.obj", "mtllib model.mtl\n" + generateObj(kind, 0));
    std::vector<std::string> notes;
    return readModel(folder / "model.obj", {}, notes);
}

} // namespace odraz::radiosity
