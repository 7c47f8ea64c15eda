#include "tools/radiosity/solve_command.h"

#include "tools/common/machine.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/baked.h"
#include "tools/radiosity/bar.h"
#include "tools/radiosity/lamps.h"
#include "tools/radiosity/solve_options.h"
#include "tools/radiosity/state.h"

#include <csignal>
#include <cstdio>

namespace odraz {

namespace {

struct Job {
    std::string model, out;
    double keepEvery = 60; // seconds
    bool progress = false; // in lines, where stderr is no terminal
    SolveOptions options;
};

Job readJob(Arguments &words) {
    Job job;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "-o")
            job.out = words.value(w);
        else if (w == "--progress")
            job.progress = true;
        else if (w == "--keep-every")
            job.keepEvery = words.number(w, 0.01, 1e9);
        else if (job.options.take(w, words))
            continue;
        else if (word[0] != '-' && job.model.empty())
            job.model = w;
        else
            words.refuse(w);
    }
    if (job.model.empty()) throw Refused("name a model: radiosity solve MODEL.obj -o OUT");
    if (job.out.empty()) throw Refused("name a file for the solution with -o OUT");
    job.options.finish();
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

void report(const Mesh &mesh, const Bake &b, size_t elements) {
    std::printf("%zu triangles, %zu polygons in one plane each; ", mesh.triangles.size(), b.material.size());
    if (b.byRays)
        std::printf("%zu elements, %d sites with %zu rays\n", elements, b.sites, b.rays);
    else
        std::printf("%d patches, %zu elements\n", b.model->patchCount, elements);
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

// Whether the even sky, which is there where nothing else shines, does not get in: a closed model, its fronts
// inside.
bool staysDark(const Baked &b) {
    double light = 0;
    for (const Rgb &c : b.emits)
        if (maxComponent(c) > 0) return false;
    for (const Rgb &c : b.light) light += (double)(c.x + c.y + c.z);
    return light < 0.01 * (double)b.light.size();
}

// The words of a command that is begun, or of one that goes on.
Job beginJob(Arguments &words, SolveState &state, std::string &resumed) {
    while (const char *word = words.next()) {
        if (std::string(word) != "--resume") {
            state.words.push_back(word);
            continue;
        }
        resumed = words.value(word);
        if (!state.words.empty() || words.next())
            throw Refused("--resume stands alone: the rest is as it was begun");
        state = SolveState::read(resumed);
        break;
    }
    std::vector<char *> pointers = {nullptr};
    for (std::string &word : state.words) pointers.push_back(word.data());
    Arguments given((int)pointers.size(), pointers.data(), "radiosity --help");
    return readJob(given);
}

} // namespace

int runSolve(Arguments &words) {
    SolveState state;
    std::string resumed;
    Job job = beginJob(words, state, resumed);
    BakeSettings &settings = job.options.settings;
    std::vector<std::string> notes;
    Mesh mesh = readObj(job.model, job.options.read, notes);
    tell(notes);
    uint64_t sum = sumOf(mesh, settings.surroundings.sky);
    if (!resumed.empty() && sum != state.model)
        throw Refused(resumed + ": was left by another model than " + job.model + " is now: solve it anew");
    state.model = sum;
    settings.resumed = std::move(state.rows);
    std::string stateFile = job.out + ".state";
    settings.keepEvery = job.keepEvery;
    settings.keep = [&](const std::string &rows) {
        state.rows = rows;
        state.save(stateFile);
        state.rows.clear();
    };
    settings.needs = [](size_t bytes) {
        std::printf("needs about %zu MB of memory\n", bytes >> 20);
        std::fflush(stdout);
    };
    Workers workers = allProcessors();
    Gl gl = settings.way == Way::kPatches ? openGl() : Gl{};
    stopAtInterrupt();
    std::unique_ptr<Bake> b;
    Bar bar(job.progress);
    auto solve = [&] {
        b.reset();
        try {
            b = bake(mesh, settings, gl, workers, &stop, [&](const char *step, float done, float residual) {
                if (step) bar.show(step, done, residual);
            });
        } catch (const ModelError &e) {
            throw ModelError(job.model + ": " + e.what());
        }
        bar.clear();
        tell(b->notes);
        return Baked(*b);
    };
    Baked baked = solve();
    if (b->whole && !settings.surroundings.shine() && !job.options.read.twoSided && staysDark(baked)) {
        tell({"no light reaches the fronts of its polygons: both sides are lit (--two-sided)"});
        job.options.read.twoSided = true;
        mesh = readObj(job.model, job.options.read, notes);
        state.words.push_back("--two-sided"); // so it goes on
        state.model = sumOf(mesh, settings.surroundings.sky);
        settings.resumed.clear();
        baked = solve();
    }
    baked.save(job.out);
    if (b->whole) std::remove(stateFile.c_str());
    report(mesh, *b, baked.elements());
    if (!b->whole) std::printf("radiosity solve --resume %s goes on\n", stateFile.c_str());
    return 0;
}

} // namespace odraz
