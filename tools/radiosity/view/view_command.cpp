#include "host/process.h"
#include "tools/radiosity/export/camera_options.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/solve_options.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/radiosity/view/help.h"
#include "tools/radiosity/view/window.h"
#include "tools/support/machine.h"

#include <cstdio>

namespace odraz::radiosity {

namespace {

struct ViewJob {
    std::string in, sky;
    bool room = false;
    ViewSettings view;
    CameraOptions camera;
    SolveOptions solve;
    RelightOptions relight;
};

void addLayer(ViewLayers &to, const std::string &name) {
    to.*common::named(kViewLayers, name, "layer", [](const ViewLayer &l) { return l.name; }).shown = true;
}

void readViewJob(common::CommandLine &line, ViewJob &job) {
    line.about("Opens a window to fly through a solution, or through a model while it is solved. Prints\n"
               "its keys when it starts. In a room from transfer, the right mouse button turns the sky, and\n"
               "the keys 1 to 9 and 0 switch lamps 1 to 10, with Shift lamps 11 to 16.");
    line.argument("FILE", job.in, "a file that solve or transfer wrote, or a model: Wavefront OBJ or glTF",
                  false);
    line.option("--screenshot", "FILE.png", job.view.screenshot,
                "write the picture when all light is found, then exit");
    line.option(
        "--layer", "NAME", [&job](const std::string &name) { addLayer(job.view.layers, name); },
        "a layer to show at the start: patches in different colours, outlines of elements, wireframe, the "
        "view of the hemicube under the pointer, or backs; repeatable");
    line.option("--sky", "R,G,B|FILE", job.sky, "the light from outside, of a room or of a model");
    job.camera.addTo(line);
    job.relight.addTo(line, false);
    line.option("--spin", "S", job.view.spin, {0.1, 3600},
                "turn the sky once in S seconds, print the pictures per second, then exit");
    job.solve.addTo(line, SolveOptions::For::kView);
    line.parse();
    if (job.in.empty()) throw common::Refused("name a solution or a model: radiosity view FILE|MODEL.obj");
    job.room = !isModel(job.in) && TransferRoom::is(job.in);
    if (!isModel(job.in)) {
        auto solving = line.givenOf(SolveOptions::groups());
        if (!job.room && line.has("--sky")) solving.push_back({"--sky", job.sky});
        if (!solving.empty())
            throw common::Refused(solving[0].option + " is an option for models: " + job.in + " is a " +
                                  (job.room ? "room" : "solution"));
    }
    if (!job.room) RelightOptions::refuseFor(job.in, line);
    (job.room ? job.relight.sky : job.solve.sky) = job.sky;
    job.solve.upIsZ = job.camera.settings.upIsZ;
    job.camera.finish(line);
    job.solve.finish(line);
    if (!job.view.screenshot.empty()) {
        claimOutput(job.view.screenshot);
        pictures::formatNamed(job.view.screenshot); // refuses other formats
    }
    job.view.name = job.in.substr(job.in.rfind('/') + 1);
    job.view.placed = job.camera.placed;
}

} // namespace

int runView(common::CommandLine &line) {
    ViewJob job;
    readViewJob(line, job);
    auto open = [&](const Vec3 &origin) {
        job.camera.moveTo(origin);
        job.view.camera = job.camera.settings;
        auto window = std::make_unique<ViewWindow>(job.view);
        if (job.view.screenshot.empty())
            std::fputs(viewKeysText(viewKeys(job.room)).c_str(), stdout), std::fflush(stdout);
        return window;
    };
    auto cameraFor = [&](const Solution &solution) {
        RenderSettings camera = job.view.camera;
        placeCamera(solution, camera);
        return camera;
    };
    if (job.room) {
        TransferRoom given = TransferRoom::read(job.in);
        Workers workers = allProcessors();
        job.relight.changeClusters(given, workers);
        job.camera.useUpOf(given.upIsZ);
        RelitRoom room(std::move(given), job.relight, ViewWindow::wake);
        auto window = open(room.model().origin);
        window->show(room, cameraFor(room.model()));
        window->run(nullptr);
        return 0;
    }
    if (!isModel(job.in)) {
        Solution solution(job.in);
        auto mesh = std::make_shared<const ViewMesh>(solution);
        auto window = open(solution.origin);
        window->show(mesh, mesh->light(solution), cameraFor(solution));
        window->run(nullptr);
        return 0;
    }
    std::vector<std::string> notes;
    Mesh mesh = readModel(job.in, job.solve.read, notes);
    job.solve.addLights(mesh, job.solve.settings.surroundings, notes);
    auto window = open(mesh.origin);
    printNotes(notes);
    BackgroundSolve solver(std::move(mesh), job.solve.settings, job.view.camera, ViewWindow::wake);
    solveNamed(job.in, [&] { window->run(&solver); });
    // End the program without waiting for the solver
    if (std::fflush(stdout)) return 1;
    if (!solver.takeNews().done) endProcess(0);
    printNotes(solver.takeNews().notes);
    return 0;
}

} // namespace odraz::radiosity
