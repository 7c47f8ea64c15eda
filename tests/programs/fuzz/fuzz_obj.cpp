// For libFuzzer: whatever a model and its materials hold, `radiosity solve` either refuses them with one line
// or can divide the model. The input is the OBJ file; bytes after a byte of 255 are its materials, m.mtl.
// Writes into the current folder.
#include "tests/programs/fuzz/use_mesh.h"

#include <fstream>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::string text((const char *)data, size), materials;
    size_t end = text.find('\xff');
    if (end != std::string::npos) materials = text.substr(end + 1), text.resize(end);
    std::ofstream("m.obj") << text;
    std::ofstream("m.mtl") << materials;
    return odraz::radiosity::useModel("m.obj", size);
}
