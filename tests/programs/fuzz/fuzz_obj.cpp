// For libFuzzer: whatever a model and its materials hold, `radiosity solve` refuses them with a line or can
// work with them. The input is the OBJ; what follows a byte of 255 becomes m.mtl beside it. It writes into
// the current folder.
#include "tests/programs/fuzz/use_mesh.h"

#include <fstream>

using namespace odraz;
using namespace odraz::radiosity;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::string text((const char *)data, size), materials;
    size_t end = text.find('\xff');
    if (end != std::string::npos) materials = text.substr(end + 1), text.resize(end);
    std::ofstream("m.obj") << text;
    std::ofstream("m.mtl") << materials;
    try {
        std::vector<std::string> notes;
        Mesh mesh = readModel("m.obj", {1, size % 2 == 1, {}}, notes);
        useMesh(mesh, size % 3 == 1);
    } catch (const common::Refused &) {
    }
    return 0;
}
