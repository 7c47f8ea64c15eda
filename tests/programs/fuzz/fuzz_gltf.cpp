// For libFuzzer: whatever a glTF file holds, `radiosity solve` either refuses it with one line or can divide
// it. Writes into the current folder.
#include "tests/programs/fuzz/use_mesh.h"

#include <fstream>

using namespace odraz;
using namespace odraz::radiosity;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::ofstream("m.gltf", std::ios::binary).write((const char *)data, (std::streamsize)size);
    try {
        std::vector<std::string> notes;
        Mesh mesh = readModel("m.gltf", {1, size % 2 == 1, {}}, notes);
        useMesh(mesh, size % 3 == 1);
        for (const BallLamp &lamp : mesh.lights.lamps)
            if (!(lamp.radius > 0 && lamp.radiance.x >= 0 && std::isfinite(lamp.centre.x))) std::abort();
        for (const Sun &sun : mesh.lights.suns)
            if (!(std::fabs(length(sun.towards) - 1) < 1e-3f && sun.light.x >= 0)) std::abort();
    } catch (const common::Refused &) {
    }
    return 0;
}
