#include "tools/radiosity/view/view_command.h"

#include "host/process.h"
#include "tools/common/whole_file.h"
#include "tools/engine/machine.h"
#include "tools/radiosity/export/camera_options.h"
#include "tools/radiosity/solve/solve_options.h"
#include "tools/radiosity/view/help.h"
#include "tools/radiosity/view/window.h"

#include <algorithm>
#include <cstdio>

namespace odraz::radiosity {

namespace {

struct Job {
    std::string in, sky;
    bool room = false;
    ViewSettings view;
    CameraOptions camera;
    SolveOptions solve;
    RelightOptions relight;
    std::string solving; // the first option that only a model to be solved can have
};

void addLayer(ViewLayers &to, const std::string &name) {
    bool &layer =
        name == "patches"     ? to.patches
        : name == "elements"  ? to.elements
        : name == "wireframe" ? to.wireframe
        : name == "hemicube"
            ? to.hemicube
            : throw common::Refused("--layer is patches, elements, wireframe or hemicube, not " + name);
    layer = true;
}

bool isModel(const std::string &path) {
    std::string end = path.substr(path.size() - std::min<size_t>(path.size(), 4));
    std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
    return end == ".obj";
}

// Hands --sky to the options that it belongs to.
void giveSky(Job &job) {
    char option[] = "--sky";
    char *pointers[] = {nullptr, job.sky.data()};
    common::Arguments value(2, pointers, "radiosity --help");
    if (job.room)
        job.relight.take(option, value);
    else
        job.solve.take(option, value), job.solving = job.solving.empty() ? option : job.solving;
}

Job readJob(common::Arguments &words) {
    Job job;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--screenshot")
            job.view.screenshot = words.value(w);
        else if (w == "--layer")
            addLayer(job.view.layers, words.value(w));
        else if (job.camera.take(w, words)) // --up belongs to both
            job.solve.upIsZ = job.camera.settings.upIsZ;
        else if (w == "--spin")
            job.view.spin = words.number(w, 0.1, 3600);
        else if (w == "--sky") // of a room or of a model: known when the file is
            job.sky = words.value(w);
        else if (job.relight.take(w, words))
            continue;
        else if (job.solve.take(w, words))
            job.solving = job.solving.empty() ? w : job.solving;
        else if (word[0] != '-' && job.in.empty())
            job.in = w;
        else
            words.refuse(w);
    }
    if (job.in.empty()) throw common::Refused("name a solution or a model: radiosity view FILE|MODEL.obj");
    job.room = !isModel(job.in) && TransferRoom::is(job.in);
    if (!job.sky.empty()) giveSky(job);
    if (!isModel(job.in) && !job.solving.empty())
        throw common::Refused(job.solving + " is an option for models: " + job.in + " is a " +
                              (job.room ? "room" : "solution"));
    if (!job.room && (!job.relight.first().empty() || job.view.spin > 0))
        throw common::Refused((job.view.spin > 0 ? "--spin" : job.relight.first()) +
                              " is for a room that `radiosity transfer` wrote; " + job.in + " is none");
    job.camera.finish("view");
    job.solve.finish();
    if (!job.view.screenshot.empty()) common::checkWritable(job.view.screenshot);
    job.view.name = job.in.substr(job.in.rfind('/') + 1);
    job.view.camera = job.camera.settings;
    job.view.placed = job.camera.placed();
    return job;
}

} // namespace

int runView(common::Arguments &words) {
    Job job = readJob(words);
    auto keys = [&] {
        if (job.view.screenshot.empty())
            std::printf("%s\n", viewKeysLine(viewKeys(job.room)).c_str()), std::fflush(stdout);
    };
    if (job.room) {
        TransferRoom given = TransferRoom::read(job.in);
        Workers workers = allProcessors();
        job.relight.changeClusters(given, workers);
        job.camera.upOf(given.upIsZ);
        job.view.camera.upIsZ = job.camera.settings.upIsZ;
        RelitRoom room(std::move(given), job.relight, ViewWindow::wake);
        ViewWindow window(job.view);
        keys();
        RenderSettings camera = job.view.camera;
        placeCamera(room.model(), camera);
        window.show(room, camera);
        window.run(nullptr);
        return 0;
    }
    if (!isModel(job.in)) {
        Solution solution(job.in);
        auto mesh = std::make_shared<const ViewMesh>(solution);
        ViewWindow window(job.view);
        keys();
        RenderSettings camera = job.view.camera;
        placeCamera(solution, camera);
        window.show(mesh, mesh->light(solution), camera);
        window.run(nullptr);
        return 0;
    }
    auto tell = [](const std::vector<std::string> &notes) {
        for (const std::string &note : notes) std::fprintf(stderr, "radiosity: %s\n", note.c_str());
    };
    std::vector<std::string> notes;
    Mesh mesh = readObj(job.in, job.solve.read, notes);
    ViewWindow window(job.view);
    keys();
    tell(notes);
    BackgroundSolve solver(std::move(mesh), job.solve.settings, job.view.camera, ViewWindow::wake);
    try {
        window.run(&solver);
    } catch (const ModelError &e) {
        throw ModelError(job.in + ": " + e.what());
    }
    // The program ends without waiting for the solver
    if (std::fflush(stdout)) return 1;
    if (!solver.take().done) endProcess(0);
    tell(solver.take().notes);
    return 0;
}

} // namespace odraz::radiosity
