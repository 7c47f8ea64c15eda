#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/generate/generate.h"

#include <algorithm>
#include <cstdio>

namespace odraz::radiosity {

int runGenerate(common::CommandLine &line) {
    std::string kind, out;
    double area = 0;
    std::vector<MaterialChange> changes;
    line.about("Writes an example model, and its materials beside it.");
    line.argument("KIND", kind, "cube, columns, corner, vault or terrain", false);
    line.option("-o", "MODEL.obj", out, "the model's file");
    line.option("--area", "A", area, {1e-4, 1e6},
                "divide polygons into triangles of at most this area; by default they stay whole");
    addMaterialChanges(line, changes);
    line.parse();
    static const char *const kinds[] = {"cube", "columns", "corner", "vault", "terrain"};
    if (std::find(std::begin(kinds), std::end(kinds), kind) == std::end(kinds))
        throw common::Refused(
            "generate makes a cube, columns, a corner, a vault or a terrain: name one of them");
    if (out.size() < 5 || out.compare(out.size() - 4, 4, ".obj"))
        throw common::Refused("name a file with -o MODEL.obj");
    common::checkWritable(out);
    std::string mtl = out.substr(0, out.size() - 4) + ".mtl", name = mtl.substr(mtl.rfind('/') + 1);
    std::string materials = generateMtl(changes);
    size_t triangles = 0;
    std::string model = generateObj(kind, area, &triangles);
    common::writeWhole(mtl, materials);
    common::writeWhole(out, "mtllib " + name + "\n" + model);
    bool fine = area > 0 || kind == "vault" || kind == "terrain";
    std::printf("%s: %zu %s\n", out.c_str(), fine ? triangles : triangles / 2,
                fine ? "triangles" : "polygons");
    return 0;
}

} // namespace odraz::radiosity
