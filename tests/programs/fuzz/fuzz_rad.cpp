// For libFuzzer: whatever a solution's file holds, `radiosity` refuses it with a line or can work with it.
// The input is the file behind its checksum, which is made to fit: else nothing would get behind it. It
// writes into the folder where it runs.
#include "tools/common/machine.h"
#include "tools/radiosity/atlas.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace odraz;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::ofstream("a.rad") << Baked::withChecksum({(const char *)data, size});
    try {
        Baked baked("a.rad");
        exportCsv(baked, "a.csv");
        exportPly(baked, "a.ply");
        exportObj(baked, "a.obj");
        for (bool radiosity : {false, true}) {
            std::vector<std::string> notes;
            std::filesystem::remove_all("atlas");
            exportAtlas(baked, {.radiosity = radiosity, .page = 1024}, "atlas", notes);
        }
        Workers workers = serialWorkers();
        RenderSettings s;
        s.width = 16, s.height = 9;
        placeCamera(baked, s);
        for (bool logarithmic : {false, true}) {
            s.logarithmic = logarithmic;
            render(baked, s, workers, "a.png");
        }
    } catch (const std::runtime_error &) {
    }
    return 0;
}
