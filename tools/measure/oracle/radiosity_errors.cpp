// Measures how far a solution of `radiosity solve` is from path tracing, at random places or at the middles
// of elements. Each place has a square number of paths; the option gives its side.
#include "tools/common/arguments.h"
#include "tools/engine/machine.h"
#include "tools/radiosity/reference/mesh_reference.h"

#include <cstdio>

using namespace odraz;
using namespace odraz::radiosity;

static constexpr char kUsage[] =
    "usage: radiosity_errors MODEL.obj SOLUTION [--probes N] [--side N] [--middles] [--list]\n";

static int run(common::Arguments &words) {
    std::string files[2];
    int probes = 1000, side = 48, count = 0;
    bool list = false, middles = false;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--probes")
            probes = words.whole(w, 1, 1000000);
        else if (w == "--side")
            side = words.whole(w, 2, 4096);
        else if (w == "--middles")
            middles = true;
        else if (w == "--list")
            list = true;
        else if (word[0] != '-' && count < 2)
            files[count++] = w;
        else
            words.refuse(w);
    }
    if (count < 2) throw common::Refused("name a model and its solution");
    std::vector<std::string> notes;
    Mesh mesh = readObj(files[0], {}, notes);
    Solution solution(files[1]);
    Surroundings around;
    if (!shines(mesh)) around.sky = evenSky({1, 1, 1});
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

int main(int argc, char **argv) { return common::runProgram("radiosity_errors", kUsage, argc, argv, run); }
