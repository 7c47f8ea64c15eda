// radiosity_errors: compares a radiosity solution with path tracing.
#include "tools/common/command_line.h"
#include "tools/radiosity/reference/mesh_reference.h"
#include "tools/support/machine.h"

#include <cstdio>

namespace odraz::measure {

using namespace radiosity;

static int run(common::CommandLine &line) {
    std::string model, file;
    int probes = 1000, side = 48;
    line.about(
        "Prints the errors of a solution of `radiosity solve` against path tracing, at random points.");
    line.argument("MODEL", model, "the model");
    line.argument("SOLUTION", file, "its solution");
    line.option("--probes", "N", probes, {1, 1000000}, "the number of points");
    line.option("--side", "N", side, {2, 4096}, "two sets of N x N paths at each point");
    line.parse();
    std::vector<std::string> notes;
    Mesh mesh = readModel(model, {}, notes);
    Solution solution(file);
    Surroundings around = mesh.lights;
    around.moveTo(mesh.origin);
    if (!emitsLight(mesh) && !around.any()) around.sky = evenSky({1, 1, 1});
    Workers workers = allProcessors();
    auto all = placeMeshProbes(solution, probes);
    tracePaths(mesh, around, all, side, workers);
    MeshErrors e = errorsOf(all);
    std::printf("%zu points: median %.2f %%, 95 of 100 below %.2f %%, rms %.2f %%, bias %+.2f %% (noise of "
                "the paths: %.2f %%)\n",
                all.size(), e.median, e.worst20, e.rms, e.bias, e.noise);
    return 0;
}

} // namespace odraz::measure

int main(int argc, char **argv) {
    return common::runProgram("radiosity_errors", argc, argv, odraz::measure::run);
}
