#include "tools/measure/oracle/measured.h"

#include "tools/common/temporary_folder.h"
#include "tools/common/whole_file.h"
#include "tools/engine/machine.h"
#include "tools/radiosity/generate/generate.h"

namespace odraz {

using namespace radiosity;

Mesh generatedMesh(const std::string &kind, double area) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "model.mtl", generateMtl());
    common::writeWhole(folder / "model.obj", "mtllib model.mtl\n" + generateObj(kind, area));
    std::vector<std::string> notes;
    return readObj(folder / "model.obj", {}, notes);
}

std::vector<Probe> referenceOf(const Mesh &mesh, const Gl &gl, Workers &workers, int probes, bool quick) {
    double area = areaOf(mesh);
    SolveSettings fine;
    fine.way = Way::kPatches;
    fine.findRows = rowsByRays(quick ? 32 : 64);
    fine.patch = area / (quick ? 4000 : 12000);
    fine.element = area / (quick ? 100000 : 500000);
    fine.lampSamples = 128;
    fine.memory = (size_t)8 << 30;
    Solved solved = solveModel(mesh, fine, gl, workers, &kNever, {});
    std::vector<Probe> places = placeProbes(*solved.patches->model, probes);
    traceProbes(solved, places, quick ? 48 : 96, workers);
    return places;
}

} // namespace odraz
