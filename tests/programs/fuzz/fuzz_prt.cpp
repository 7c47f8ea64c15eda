// For libFuzzer: whatever a room's file holds, `radiosity` either refuses it with one line or can relight it.
// The input is the file without its checksum, which is appended. Writes into the current folder.
#include "tools/radiosity/export/points_export.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/transfer/environment.h"
#include "tools/radiosity/transfer/relight.h"
#include "tools/support/machine.h"

#include <fstream>
#include <stdexcept>

using namespace odraz;
using namespace odraz::radiosity;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::ofstream("a.prt") << withChecksum(kTransferMagic, {(const char *)data, size});
    try {
        TransferRoom room = TransferRoom::read("a.prt");
        Workers workers = serialWorkers();
        RenderSettings s;
        s.width = 16, s.height = 9;
        placeCamera(room.model, s);
        BandLight sky = turnedSky(project(Rgb{1, 2, 3}).light, room, 50, 20);
        for (int rank : {-1, 0, room.clusters.rank}) {
            Lighting lighting = {.sky = sky, .lamps = {}, .bands = room.bands, .rank = rank};
            Solution lit = litModel(room, lighting, &s.eye);
            render(lit, s, workers, "a.png");
            exportCsv(lit, "a.csv");
        }
    } catch (const std::runtime_error &) {
    }
    return 0;
}
