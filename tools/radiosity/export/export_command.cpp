#include "tools/radiosity/export/atlas.h"
#include "tools/radiosity/export/camera_options.h"
#include "tools/radiosity/export/points_export.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/transfer/relight_options.h"
#include "tools/support/machine.h"

#include <cstdio>

namespace odraz::radiosity {

namespace {

constexpr char kAtlas[] = "Lightmaps";

void writeAtlas(const Solution &solution, const std::string &folder, const AtlasSettings &settings) {
    std::vector<std::string> notes;
    exportAtlas(solution, settings, folder, notes);
    for (const std::string &note : notes) std::printf("%s\n", note.c_str());
}

// The kinds of output, one row each.
constexpr struct ExportKind {
    const char *option, *value, *what;
    void (*write)(const Solution &solution, const std::string &to, const AtlasSettings &settings);
} kExportKinds[] = {
    {"--csv", "FILE", "a line for every element",
     [](const Solution &b, const std::string &to, const AtlasSettings &) { exportCsv(b, to); }},
    {"--ply", "FILE", "a mesh with sRGB colours at its points",
     [](const Solution &b, const std::string &to, const AtlasSettings &) { exportPolygons(b, to, true); }},
    {"--obj", "FILE", "the same as OBJ",
     [](const Solution &b, const std::string &to, const AtlasSettings &) { exportPolygons(b, to, false); }},
    {"--atlas", "DIR",
     "a new folder with lightmaps (PNG, and linear HDR and EXR) and the model as OBJ and glTF with the "
     "coordinates "
     "of the lightmaps",
     writeAtlas}};

} // namespace

int runExport(common::CommandLine &line) {
    std::string in, out;
    const ExportKind *kind = nullptr;
    AtlasSettings s;
    RelightOptions relight;
    line.about("Writes a solution, or a room from transfer, for other programs.");
    line.argument("SOLUTION", in, "a file that solve or transfer wrote", false);
    for (const ExportKind &k : kExportKinds) {
        auto read = [&](const std::string &path) {
            if (kind) throw common::Refused("give only one of --csv, --ply, --obj and --atlas");
            kind = &k, out = path;
        };
        line.option(k.option, k.value, read, k.what);
    }
    line.group(kAtlas);
    line.option(
        "--map", {"light", "radiosity"}, s.radiosity,
        "irradiance over pi, which viewers multiply by colours; or visible light, emission included, as "
        "Blender needs it");
    line.option("--texels", "N", s.texels, {1e-9, 1e9},
                "texels per unit of length; by default as fine as the elements, which is exact");
    line.option("--padding", "N", s.padding, {1, 64}, "texels of padding around every polygon");
    line.option("--page", "PX", s.page, {256, 16384}, "longest side of a page");
    relight.addTo(line);
    line.parse();
    if (in.empty() || !kind || out.empty())
        throw common::Refused("export needs a solution and a file: radiosity export OUT --csv FILE");
    if (auto given = line.givenOf({kAtlas}); !given.empty() && kind->write != writeAtlas)
        throw common::Refused(given[0].option + " belongs to --atlas DIR");
    if (kind->write != writeAtlas) claimOutput(out);
    Workers workers = allProcessors();
    kind->write(readLit(in, relight, line, workers), out, s);
    return 0;
}

int runRender(common::CommandLine &line) {
    std::string in, out;
    CameraOptions camera;
    RelightOptions relight;
    line.about("Traces a picture. The exposure adapts to what the camera sees.");
    line.argument("SOLUTION", in, "a file that solve or transfer wrote", false);
    line.option("-o", "FILE.png", out, "the picture; FILE.exr: linear radiance, without exposure and tone");
    camera.addTo(line);
    relight.addTo(line);
    line.parse();
    if (in.empty() || out.empty()) throw common::Refused("render needs a solution and -o FILE.png");
    camera.finish(line);
    claimOutput(out);
    pictures::formatNamed(out, pictures::Format::Exr); // refuses other formats
    Workers workers = allProcessors();
    RenderSettings &s = camera.settings;
    auto eyeFor = [&](const Solution &solution, const TransferRoom *room) {
        if (room) camera.useUpOf(room->upIsZ);
        camera.moveTo(solution.origin);
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
