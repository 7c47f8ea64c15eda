#include "tools/engine/machine.h"
#include "tools/radiosity/export/camera_options.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/transfer/relight_options.h"

#include <cstdio>

namespace odraz::radiosity {

int runRender(common::CommandLine &line) {
    std::string in, out;
    CameraOptions camera;
    RelightOptions relight;
    line.about("Traces a picture. The exposure adapts to what the camera sees.");
    line.argument("SOLUTION", in, "a file that solve or transfer wrote", false);
    line.option("-o", "FILE.png", out, "the picture");
    camera.addTo(line);
    relight.addTo(line);
    line.parse();
    if (in.empty() || out.empty()) throw common::Refused("render needs a solution and -o FILE.png");
    camera.finish(line);
    claimOutput(out);
    Workers workers = allProcessors();
    RenderSettings &s = camera.settings;
    auto eyeFor = [&](const Solution &solution, const TransferRoom *room) {
        if (room) camera.upOf(room->upIsZ);
        camera.moveTo(solution.place);
        if (!camera.placed) {
            placeCamera(solution, s);
            std::printf("%s\n", placeOptions(s).c_str());
        }
        return s.eye;
    };
    Solution solution = readLit(in, relight, line, workers, eyeFor);
    render(solution, s, workers, out);
    return 0;
}

} // namespace odraz::radiosity
