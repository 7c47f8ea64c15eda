#include "tools/radiosity/solve/solve_command.h"

#include "tools/common/machine.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/patches/lamps.h"
#include "tools/radiosity/solution/solve_state.h"
#include "tools/radiosity/solve/progress_bar.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/solve_options.h"

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
    action.sa_flags = (int)SA_RESETHAND; // a second Ctrl-C ends the program
    sigaction(SIGINT, &action, nullptr);
}

void tell(const std::vector<std::string> &notes) {
    for (const std::string &note : notes) std::fprintf(stderr, "radiosity: %s\n", note.c_str());
}

void printReport(const Mesh &mesh, const Solved &solved, const SolveSettings &settings) {
    const SolveReport &r = solved.report;
    bool byRays = !solved.patches;
    auto seconds = [&](SolveStep step) { return r.seconds[(int)step]; };
    std::printf("%zu triangles, %zu polygons in one plane each; ", mesh.triangles.size(),
                solved.solution.charts.size());
    size_t elements = solved.solution.elements();
    if (byRays)
        std::printf("%zu elements, %d sites with %zu rays\n", elements, r.sites, r.raysFromSite);
    else
        std::printf("%d patches, %zu elements\n", r.patches, elements);
    std::printf("processor seconds: dividing %.2f, form factors %.2f", seconds(SolveStep::kDividing),
                seconds(SolveStep::kFormFactors));
    if (!byRays) std::printf(" (%d hemicubes)", r.rows);
    std::printf(", direct light %.2f, solving %.2f\n", seconds(SolveStep::kDirectLight),
                seconds(SolveStep::kSolving));
    if (r.lamps > kManyLamps) std::printf("%zu lamps: seen by hemicubes\n", r.lamps);
    if (!r.whole)
        std::printf("stopped: direct light, and the rows of %d %s\n", r.rows, byRays ? "sites" : "patches");
    else if (settings.bounces >= 0)
        std::printf("%d bounces\n", r.sweeps);
    else
        std::printf("%d sweeps, residual %.1e\n", r.sweeps, (double)r.residual);
}

// Whether the even sky, which is added if nothing else emits, cannot get in: the model is closed and its
// fronts face inwards.
bool staysDark(const Solution &b) {
    double light = 0;
    for (const Rgb &c : b.emits)
        if (maxComponent(c) > 0) return false;
    for (const Rgb &c : b.light) light += (double)(c.x + c.y + c.z);
    return light < 0.01 * (double)b.light.size();
}

// Takes the words of a new command, or of one that is resumed.
Job beginJob(Arguments &words, SolveState &state, std::string &resumed) {
    while (const char *word = words.next()) {
        if (std::string(word) != "--resume") {
            state.words.push_back(word);
            continue;
        }
        resumed = words.value(word);
        if (!state.words.empty() || words.next())
            throw Refused("--resume takes no other option: it continues with the original ones");
        state = SolveState::read(resumed);
        break;
    }
    std::vector<char *> pointers = {nullptr};
    for (std::string &word : state.words) pointers.push_back(word.data());
    Arguments given((int)pointers.size(), pointers.data(), "radiosity --help");
    return readJob(given);
}

// Solves a job; if an even sky lights no front, solves it again with both sides lit.
class SolveCommand {
public:
    SolveCommand(Job job, SolveState state) : job(std::move(job)), state(std::move(state)) {}

    void run(const std::string &resumed) {
        readModel();
        if (!resumed.empty() && modelSum != state.model)
            throw Refused(resumed + ": belongs to another model than " + job.model +
                          " is now: solve it again");
        state.model = modelSum;
        prepare();
        Solved solved = solve();
        if (mayLightBacks() && solved.report.whole && staysDark(solved.solution)) {
            tell({"no light reaches the fronts of the polygons: both sides are lit (--two-sided)"});
            lightBacks();
            solved = {};
            solved = solve();
        }
        solved.solution.save(job.out);
        if (solved.report.whole) std::remove(stateFile().c_str());
        printReport(mesh, solved, job.options.settings);
        if (!solved.report.whole)
            std::printf("to continue: radiosity solve --resume %s\n", stateFile().c_str());
    }

private:
    Job job;
    SolveState state;
    Mesh mesh;
    uint64_t modelSum = 0;
    Workers workers = allProcessors();
    Gl gl = {};
    std::unique_ptr<ProgressBar> bar;

    std::string stateFile() const { return job.out + ".state"; }

    void readModel() {
        std::vector<std::string> notes;
        mesh = readObj(job.model, job.options.read, notes);
        tell(notes);
        modelSum = sumOf(mesh, job.options.settings.surroundings.sky);
    }

    void prepare() {
        SolveSettings &settings = job.options.settings;
        settings.resumed = std::move(state.rows);
        settings.keepEvery = job.keepEvery;
        settings.keep = [this](const std::string &rows) {
            state.rows = rows;
            state.save(stateFile());
            state.rows.clear();
        };
        settings.needs = [](size_t bytes) {
            std::printf("needs about %zu MB of memory\n", bytes >> 20);
            std::fflush(stdout);
        };
        if (settings.way == Way::kPatches) gl = openGl();
        stopAtInterrupt();
        bar = std::make_unique<ProgressBar>(job.progress);
    }

    Solved solve() {
        auto progress = [this](const char *step, float done, float residual) {
            if (step) bar->show(step, done, residual);
        };
        Solved solved;
        try {
            solved = solveModel(mesh, job.options.settings, gl, workers, &stop, progress);
        } catch (const ModelError &e) {
            throw ModelError(job.model + ": " + e.what());
        }
        bar->clear();
        tell(solved.report.notes);
        return solved;
    }

    bool mayLightBacks() const {
        const SolveSettings &settings = job.options.settings;
        return settings.evenSky && !settings.surroundings.shine() && !job.options.read.twoSided;
    }
    void lightBacks() {
        job.options.read.twoSided = true;
        std::vector<std::string> known; // notes that were printed already
        mesh = readObj(job.model, job.options.read, known);
        state.words.push_back("--two-sided"); // for --resume
        state.model = sumOf(mesh, job.options.settings.surroundings.sky);
        job.options.settings.resumed.clear();
    }
};

} // namespace

int runSolve(Arguments &words) {
    SolveState state;
    std::string resumed;
    Job job = beginJob(words, state, resumed);
    SolveCommand(std::move(job), std::move(state)).run(resumed);
    return 0;
}

} // namespace odraz
