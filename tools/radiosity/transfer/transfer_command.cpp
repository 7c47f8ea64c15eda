#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/solve_options.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/radiosity/transfer/check.h"
#include "tools/support/machine.h"

#include <cstdio>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

struct TransferJob {
    std::string model, out;
    bool check = false;
    std::vector<std::string> skies; // pictures of skies for --check
    SolveOptions options;
    TransferSettings settings;
};

void readGloss(const std::string &text, TransferSettings &s) {
    auto numbers = common::numbersOf("--gloss", text, 2);
    s.polish = (float)numbers[0], s.exponent = (float)numbers[1];
    common::need(s.polish >= 0 && s.polish <= 1 && s.exponent >= 1 && s.exponent <= 1000,
                 "--gloss takes a reflectance, 0 to 1, and an exponent, 1 to 1000, like 0.06,16, not " +
                     text);
}

void readTransferJob(common::CommandLine &line, TransferJob &job) {
    TransferSettings &s = job.settings;
    line.about(
        "Solves a model, by rays and with all bounces, for any light from outside, and for each of its\n"
        "lamps: an emitting material, a ball or a sun. render, export and view show the room in any of\n"
        "these lights.");
    line.argument("MODEL", job.model, "a Wavefront OBJ or glTF", false);
    line.option("-o", "ROOM.prt", job.out, "the file of the room");
    line.option("--bands", "N", s.bands, {1, kMostBands}, "number of bands of spherical harmonics");
    line.option("--clusters", "K", s.clusters, {1, kMostClusters},
                "clusters of the compressed rows; by default 4 for each function of the bands");
    line.option("--rank", "R", s.rank, {1, kMostRank},
                "axes of each cluster; by default 8 to 32, depending on the bands");
    line.option("--glossy", "MATERIAL", s.glossy, "polish planes of MATERIAL: they mirror the room, blurred");
    line.option(
        "--gloss", "R,E", [&s](const std::string &text) { readGloss(text, s); },
        "the polish: its reflectance seen from above, and the exponent of its lobe, 1 to 1000 "
        "(default 0.06,16)");
    line.flag("--check", job.check,
              "compare with solutions for several lights, and one subspace with clusters");
    line.option("--sky", "FILE", job.skies, "with --check: also compare under this sky");
    job.options.addTo(line, SolveOptions::For::kTransfer);
    line.parse();
    common::need(!job.model.empty(), "name a model: radiosity transfer MODEL.obj -o ROOM.prt");
    common::need(!job.out.empty(), "name a file for the room with -o ROOM.prt");
    common::need(job.skies.empty() || job.check, "--sky belongs to --check: a room is solved for any sky");
    job.options.finish(line);
    s.solve = job.options.settings, s.upIsZ = job.options.upIsZ;
    for (const std::string &sky : job.skies) common::noteInput(sky); // they are read after the room is saved
    claimOutput(job.out);
}

void printTransferReport(const Mesh &mesh, const TransferRoom &room, const TransferReport &r) {
    auto counted = [](auto count, const char *what) { return common::counted((size_t)count, what); };
    std::printf("%s, %s in one plane each; %s, %s with %s\n",
                counted(mesh.triangles.size(), "triangle").c_str(),
                counted(room.model.charts.size(), "polygon").c_str(), counted(room.texels(), "texel").c_str(),
                counted(r.sites, "site").c_str(), counted(r.raysFromSite, "ray").c_str());
    std::printf("%s, %s", counted(room.bands, "band").c_str(), counted(room.functions(), "function").c_str());
    for (size_t k = 0; k < room.lamps.size(); ++k)
        std::printf("%s %zu %s", k ? "," : "; lamps", k + 1, room.lamps[k].c_str());
    std::printf("\n%s of %s: %.1f MB instead of %.1f\n", counted(room.clusters.count, "cluster").c_str(),
                common::counted((size_t)room.clusters.rank, "axis", "axes").c_str(),
                (double)room.clusters.floats(room.clusters.rank) * 4e-6,
                (double)(room.texels() * (size_t)(3 * room.bases())) * 4e-6);
    if (!room.gloss.empty()) std::printf("gloss in %s\n", counted(r.squares, "square").c_str());
    std::printf("processor seconds: rays %.2f, solving %.2f, clusters %.2f, gloss %.2f\n", r.seconds[0],
                r.seconds[1], r.seconds[2], r.seconds[3]);
}

} // namespace

int runTransfer(common::CommandLine &line) {
    TransferJob job;
    readTransferJob(line, job);
    std::vector<std::string> notes;
    Mesh mesh = readModel(job.model, job.options.read, notes);
    job.options.addLights(mesh, job.settings.solve.surroundings, notes);
    printNotes(notes);
    Workers workers = allProcessors();
    ProgressBar bar(job.options.progress);
    TransferReport report;
    auto progress = [&](auto... shown) { bar.show(shown...); };
    TransferRoom room =
        solveNamed(job.model, [&] { return findTransfer(mesh, job.settings, workers, progress, report); });
    bar.clear();
    printNotes(report.notes);
    room.save(job.out);
    printTransferReport(mesh, room, report);
    std::fflush(stdout);
    if (!job.check) return 0;
    const int *stop = stopAt({SIGINT, SIGTERM});
    if (!printCheck(mesh, job.settings, room, (int)report.raysFromSite, job.skies, workers, stop)) {
        std::fflush(stdout);
        throw std::runtime_error("interrupted: the check is incomplete; " + job.out + " is saved");
    }
    return 0;
}

} // namespace odraz::radiosity
