// For libFuzzer: whatever a glTF file holds, `radiosity solve` either refuses it with one line or can divide
// it. Writes into the current folder.
#include "tests/programs/fuzz/use_mesh.h"

#include <fstream>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::ofstream("m.gltf", std::ios::binary).write((const char *)data, (std::streamsize)size);
    return odraz::radiosity::useModel("m.gltf", size);
}
