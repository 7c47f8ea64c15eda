// For libFuzzer: whatever a solution's file holds, `radiosity` either refuses it with one line or can export
// and render it. The input is the file without its checksum, which is appended: a mutated file would almost
// never have the right one. Writes into the current folder.
#include "tools/radiosity/export/atlas.h"
#include "tools/radiosity/export/points_export.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/support/machine.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace odraz;
using namespace odraz::radiosity;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::ofstream("a.rad") << withChecksum(kSolutionMagic, {(const char *)data, size});
    try {
        Solution solution("a.rad");
        exportCsv(solution, "a.csv");
        exportPolygons(solution, "a.ply", true);
        exportPolygons(solution, "a.obj", false);
        for (bool radiosity : {false, true}) {
            std::vector<std::string> notes;
            std::filesystem::remove_all("atlas");
            exportAtlas(solution, {.radiosity = radiosity, .page = 1024}, "atlas", notes);
        }
        Workers workers = serialWorkers();
        RenderSettings s;
        s.width = 16, s.height = 9;
        placeCamera(solution, s);
        for (bool logarithmic : {false, true}) {
            s.logarithmic = logarithmic;
            render(solution, s, workers, "a.png");
        }
    } catch (const std::runtime_error &) {
    }
    return 0;
}
