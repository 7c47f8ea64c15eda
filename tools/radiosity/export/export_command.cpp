#include "tools/engine/machine.h"
#include "tools/radiosity/export/atlas.h"
#include "tools/radiosity/export/points_export.h"
#include "tools/radiosity/transfer/relight_options.h"

#include <cstdio>

namespace odraz::radiosity {

static constexpr char kAtlas[] = "Lightmaps";

int runExport(common::CommandLine &line) {
    std::string in, kind, out;
    AtlasSettings s;
    RelightOptions relight;
    line.about("Writes a solution, or a room from transfer, for other programs.");
    line.argument("SOLUTION", in, "a file that solve or transfer wrote", false);
    auto writes = [&](const std::string &option, const std::string &value, const std::string &what) {
        auto take = [&, option](const std::string &path) {
            if (!out.empty()) throw common::Refused("export writes one thing at a time");
            kind = option, out = path;
        };
        line.option(option, value, take, what);
    };
    writes("--csv", "FILE", "a line for every element");
    writes("--ply", "FILE", "a mesh with colours at its points");
    writes("--obj", "FILE", "the same as OBJ");
    writes("--atlas", "DIR",
           "a new folder with lightmaps (PNG, and linear HDR) and the model as OBJ and glTF with the "
           "coordinates of the "
           "lightmaps");
    line.group(kAtlas);
    line.option("--map", {"light", "radiosity"}, s.radiosity,
                "irradiance over pi, which viewers multiply by colours; or visible light, emission included");
    line.option("--texels", "N", s.texels, {1e-9, 1e9},
                "texels per unit of length; by default as fine as the elements, which is exact");
    line.option("--padding", "N", s.padding, {1, 64}, "texels of padding around every polygon");
    line.option("--page", "PX", s.page, {256, 16384}, "longest side of a page");
    relight.addTo(line);
    line.parse();
    if (in.empty() || out.empty())
        throw common::Refused("export needs a solution and a file: radiosity export OUT --csv FILE");
    if (auto given = line.givenOf({kAtlas}); !given.empty() && kind != "--atlas")
        throw common::Refused(given[0].option + " belongs to --atlas DIR");
    Workers workers = allProcessors();
    Solution solution = readLit(in, relight, line, workers);
    if (kind == "--atlas") {
        std::vector<std::string> notes;
        exportAtlas(solution, s, out, notes);
        for (const std::string &note : notes) std::printf("%s\n", note.c_str());
        return 0;
    }
    kind == "--csv" ? exportCsv(solution, out) : exportPolygons(solution, out, kind == "--ply");
    return 0;
}

} // namespace odraz::radiosity
