// radiosity_errors: how far a solution is from path tracing.
#include "tools/common/command_line.h"
#include "tools/engine/machine.h"
#include "tools/radiosity/reference/mesh_reference.h"

#include <cstdio>

namespace odraz::measure {

using namespace radiosity;

static int run(common::CommandLine &line) {
    std::string model, file;
    int probes = 1000, side = 48;
    bool list = false, middles = false;
    line.about("Prints how far a solution of `radiosity solve` is from path tracing, at random places.");
    line.argument("MODEL", model, "the model");
    line.argument("SOLUTION", file, "its solution");
    line.option("--probes", "N", probes, {1, 1000000}, "the number of places");
    line.option("--side", "N", side, {2, 4096}, "each place has N x N paths, twice");
    line.flag("--middles", middles, "places are the middles of elements");
    line.flag("--list", list, "also print each place, its normal, and its light, solved and traced");
    line.parse();
    std::vector<std::string> notes;
    Mesh mesh = readModel(model, {}, notes);
    Solution solution(file);
    Surroundings around = mesh.lights;
    around.moveTo(mesh.place);
    if (!emitsLight(mesh) && !around.any()) around.sky = evenSky({1, 1, 1});
    Workers workers = allProcessors();
    auto all = placeMeshProbes(solution, probes, middles);
    tracePaths(mesh, around, all, side, workers);
    if (list)
        for (const MeshProbe &p : all)
            std::printf("%g %g %g  %g %g %g  %.5g %.5g %.5g  %.5g %.5g %.5g\n", (double)p.p.x, (double)p.p.y,
                        (double)p.p.z, (double)p.n.x, (double)p.n.y, (double)p.n.z, (double)p.solved.x,
                        (double)p.solved.y, (double)p.solved.z, (double)p.traced.x, (double)p.traced.y,
                        (double)p.traced.z);
    MeshErrors e = errorsOf(all);
    std::printf("%zu places: median %.2f %%, 95 of 100 below %.2f %%, rms %.2f %%, bias %+.2f %% (the paths' "
                "noise %.2f %%)\n",
                all.size(), e.median, e.worst20, e.rms, e.bias, e.noise);
    return 0;
}

} // namespace odraz::measure

int main(int argc, char **argv) {
    return common::runProgram("radiosity_errors", argc, argv, odraz::measure::run);
}
