#include "tools/radiosity/solve_command.h"

#include "tools/common/machine.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/baked.h"
#include "tools/radiosity/bar.h"
#include "tools/radiosity/lamps.h"

#include <csignal>
#include <cstdio>

namespace odraz {

namespace {

struct Job {
    std::string model, out;
    BakeSettings settings;
};

Job readJob(Arguments &words) {
    Job job;
    BakeSettings &s = job.settings;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "-o")
            job.out = words.value(w);
        else if (w == "--hemicube") {
            s.hemicube = words.whole(w, 4, kMaxHemicube);
            if (s.hemicube % 2) throw Refused("--hemicube takes an even number");
        } else if (w == "--patch")
            s.patch = words.number(w, 1e-18, 1e30);
        else if (w == "--element")
            s.element = words.number(w, 1e-18, 1e30);
        else if (w == "--bounces")
            s.bounces = words.whole(w, 0, 10000);
        else if (w == "--residual")
            s.residual = (float)words.number(w, 1e-7, 1);
        else if (w == "--lamp-samples")
            s.lampSamples = words.whole(w, 1, kMaxLampCells);
        else if (w == "--memory")
            s.memory = (size_t)(words.number(w, 1, 1e6) * 1048576);
        else if (w == "--adaptive")
            s.adaptive = true;
        else if (w == "--direct")
            s.analytic = words.choice(w, "analytic", "hemicube");
        else if (word[0] != '-' && job.model.empty())
            job.model = w;
        else
            words.refuse(w);
    }
    if (job.model.empty()) throw Refused("name a model: radiosity solve MODEL.obj -o OUT");
    if (job.out.empty()) throw Refused("name a file for the solution with -o OUT");
    checkWritable(job.out);
    return job;
}

int stop = 0; // becomes 1 with Ctrl-C

void stopAtInterrupt() {
    struct sigaction action = {};
    action.sa_handler = [](int) { __atomic_store_n(&stop, 1, __ATOMIC_RELAXED); };
    action.sa_flags = (int)SA_RESETHAND; // the second one ends the program
    sigaction(SIGINT, &action, nullptr);
}

void tell(const std::vector<std::string> &notes) {
    for (const std::string &note : notes) std::fprintf(stderr, "radiosity: %s\n", note.c_str());
}

void report(const Mesh &mesh, const Bake &b, int elements) {
    const Model &m = *b.model;
    std::printf("%zu triangles, %d polygons in one plane each; %d patches, %d elements\n",
                mesh.triangles.size(), m.chartCount, m.patchCount, elements);
    std::printf("processor seconds: dividing %.2f, form factors %.2f (%d hemicubes), direct light %.2f, "
                "solving %.2f\n",
                b.seconds[0], b.seconds[1], b.rows, b.seconds[2], b.seconds[3]);
    if (b.glows.size() > kManyLamps) std::printf("%zu lamps: seen by hemicubes\n", b.glows.size());
    if (!b.whole)
        std::printf("stopped: direct light, and the rows of %d patches\n", b.rows);
    else if (b.settings.bounces >= 0)
        std::printf("%d bounces\n", b.sweeps);
    else
        std::printf("%d sweeps, residual %.1e\n", b.sweeps, (double)b.left);
}

} // namespace

int runSolve(Arguments &words) {
    Job job = readJob(words);
    std::vector<std::string> notes;
    Mesh mesh = readObj(job.model, notes);
    tell(notes);
    Workers workers = allProcessors();
    Gl gl = openGl();
    stopAtInterrupt();
    std::unique_ptr<Bake> b;
    Bar bar;
    try {
        b = bake(mesh, job.settings, gl, workers, &stop, [&](const char *step, float done, float residual) {
            if (step) bar.show(step, done, residual);
        });
    } catch (const ModelError &e) {
        throw ModelError(job.model + ": " + e.what());
    }
    bar.clear();
    tell(b->notes);
    Baked baked(*b);
    baked.save(job.out);
    int elements = 0, last = -1;
    baked.forPieces([&](int, int cell, const std::vector<BakedPoint> &) {
        elements += cell != last;
        last = cell;
    });
    report(mesh, *b, elements);
    return 0;
}

} // namespace odraz
