#include "tools/radiosity/solve_command.h"

#include "tools/common/machine.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/baked.h"
#include "tools/radiosity/bar.h"
#include "tools/radiosity/lamps.h"

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace odraz {

namespace {

struct Job {
    std::string model, out;
    ReadSettings read;
    BakeSettings settings;
};

// So many numbers between commas.
template <size_t N> std::array<double, N> readNumbers(const std::string &option, const std::string &text) {
    std::array<double, N> n;
    const char *p = text.c_str();
    for (size_t i = 0; i < N; ++i) {
        char *end;
        n[i] = std::strtod(p, &end);
        if (end == p || !std::isfinite(n[i]) || *end != (i + 1 < N ? ',' : 0))
            throw Refused(option + " takes " + std::to_string(N) + " numbers with commas between, not '" +
                          text + "'");
        p = end + 1;
    }
    return n;
}

Rgb readLight(const std::string &option, const double *n) {
    for (int k = 0; k < 3; ++k)
        if (!(n[k] >= 0 && n[k] < 1e12))
            throw Refused(option + ": light must not be negative, and below 1e12");
    return {(float)n[0], (float)n[1], (float)n[2]};
}

// What lights it from outside; which way is up must be known before.
struct Outside {
    std::string sky;
    std::vector<std::string> suns, lamps;
    bool upIsZ = false;

    void read(Surroundings &to) const {
        double n[3];
        char rest;
        if (std::sscanf(sky.c_str(), "%lf,%lf,%lf%c", n, n + 1, n + 2, &rest) == 3)
            to.sky = evenSky(readLight("--sky", n));
        else if (!sky.empty())
            to.sky = readSky(sky, upIsZ, to.suns);
        for (const std::string &text : suns) {
            auto s = readNumbers<5>("--sun", text);
            to.suns.push_back({sunTowards(s[0], s[1], upIsZ), readLight("--sun", &s[2])});
        }
        for (const std::string &text : lamps) {
            auto l = readNumbers<7>("--lamp", text);
            if (!(l[3] > 0)) throw Refused("--lamp: its size must be above 0");
            to.lamps.push_back(
                {{(float)l[0], (float)l[1], (float)l[2]}, (float)l[3] / 2, readLight("--lamp", &l[4])});
        }
        if (to.suns.size() > kMaxSuns || to.lamps.size() > kMaxLamps)
            throw Refused("at most " + std::to_string(kMaxSuns) +
                          " suns, those of a sky's picture too, and " + std::to_string(kMaxLamps) + " lamps");
    }
};

Job readJob(Arguments &words) {
    Job job;
    BakeSettings &s = job.settings;
    Outside outside;
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
        else if (w == "--rays")
            s.rays = words.whole(w, 8, 32768), s.way = Way::kRays;
        else if (w == "--final")
            s.final = words.whole(w, 8, 65536), s.way = Way::kRays;
        else if (w == "--residual")
            s.residual = (float)words.number(w, 1e-7, 1);
        else if (w == "--lamp-samples")
            s.lampSamples = words.whole(w, 1, kMaxLampCells);
        else if (w == "--memory")
            s.memory = (size_t)(words.number(w, 1, 1e6) * 1048576);
        else if (w == "--sky")
            outside.sky = words.value(w);
        else if (w == "--sun")
            outside.suns.push_back(words.value(w));
        else if (w == "--lamp")
            outside.lamps.push_back(words.value(w));
        else if (w == "--sky-rays") {
            int across = (int)std::lround(std::sqrt(words.whole(w, 4, 65536)) / 2) * 2;
            s.surroundings.skyRays = across * across;
        } else if (w == "--up")
            outside.upIsZ = words.choice(w, "z", "y");
        else if (w == "--scale")
            job.read.scale = words.number(w, 1e-9, 1e9);
        else if (w == "--two-sided")
            job.read.twoSided = true;
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
    outside.read(s.surroundings);
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
    std::printf("%zu triangles, %zu polygons in one plane each; ", mesh.triangles.size(), b.material.size());
    if (b.byRays)
        std::printf("%d elements, %d sites with %zu rays\n", elements, b.sites, b.rays);
    else
        std::printf("%d patches, %d elements\n", b.model->patchCount, elements);
    std::printf("processor seconds: dividing %.2f, form factors %.2f", b.seconds[0], b.seconds[1]);
    if (!b.byRays) std::printf(" (%d hemicubes)", b.rows);
    std::printf(", direct light %.2f, solving %.2f\n", b.seconds[2], b.seconds[3]);
    if (b.glows.size() > kManyLamps) std::printf("%zu lamps: seen by hemicubes\n", b.glows.size());
    if (!b.whole)
        std::printf("stopped: direct light, and the rows of %d %s\n", b.rows, b.byRays ? "sites" : "patches");
    else if (b.settings.bounces >= 0)
        std::printf("%d bounces\n", b.sweeps);
    else
        std::printf("%d sweeps, residual %.1e\n", b.sweeps, (double)b.left);
}

} // namespace

int runSolve(Arguments &words) {
    Job job = readJob(words);
    std::vector<std::string> notes;
    Mesh mesh = readObj(job.model, job.read, notes);
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
