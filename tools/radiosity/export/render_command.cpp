#include "tools/common/whole_file.h"
#include "tools/engine/machine.h"
#include "tools/radiosity/export/camera_options.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/export/transfer_pictures.h"
#include "tools/radiosity/transfer/relight_options.h"

#include <cstdio>

namespace odraz::radiosity {

int runRender(common::CommandLine &line) {
    std::string in, out, pictures;
    CameraOptions camera;
    RelightOptions relight;
    line.about("Traces a picture. The exposure adapts to what the camera sees.");
    line.argument("SOLUTION", in, "a file that solve or transfer wrote", false);
    line.option("-o", "FILE.png", out, "the picture");
    line.option("--pictures", "DIR", pictures,
                "of a room: instead, write the functions of its bands, and what each band adds");
    camera.addTo(line);
    relight.addTo(line);
    line.parse();
    if (!in.empty() && !pictures.empty()) {
        if (!out.empty()) throw common::Refused("--pictures DIR names its files itself: leave out -o");
        if (!TransferRoom::is(in))
            throw common::Refused("--pictures is for a room that `radiosity transfer` wrote; " + in +
                                  " is none");
        camera.finish(line);
        Workers workers = allProcessors();
        TransferRoom room = TransferRoom::read(in);
        relight.changeClusters(room, workers);
        camera.upOf(room.upIsZ);
        camera.moveTo(room.model.place);
        if (!camera.placed) placeCamera(room.model, camera.settings);
        picturesOf(room, relight.of(room).lighting, camera.settings, workers, pictures);
        return 0;
    }
    if (in.empty() || out.empty()) throw common::Refused("render needs a solution and -o FILE.png");
    camera.finish(line);
    common::checkWritable(out);
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
