#include "tools/measure/oracle/generated_mesh.h"

#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/generate/generate.h"

namespace odraz::measure {

using namespace radiosity;

Mesh generatedMesh(const std::string &kind, double area) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "model.mtl", generateMtl());
    common::writeWhole(folder / "model.obj", "mtllib model.mtl\n" + generateObj(kind, area));
    std::vector<std::string> notes;
    return readModel(folder / "model.obj", {}, notes);
}

} // namespace odraz::measure
