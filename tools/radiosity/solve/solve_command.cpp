#include "tools/radiosity/solve/solve_command.h"

#include "tools/common/machine.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/patches/lamps.h"
#include "tools/radiosity/solution/kept_rows.h"
#include "tools/radiosity/solution/memory.h"
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
    std::string relight;   // a solution whose rows are used
    double keepEvery = 60; // seconds
    bool keepRows = false;
    bool progress = false; // in lines, where stderr is no terminal
    SolveOptions options;
};

std::string rowsFile(const std::string &solution) { return solution + ".rows"; }

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
        else if (w == "--keep-rows")
            job.keepRows = true;
        else if (w == "--relight")
            job.relight = words.value(w);
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
    return job;
}

Job readJob(std::vector<std::string> words) {
    std::vector<char *> pointers = {nullptr};
    for (std::string &word : words) pointers.push_back(word.data());
    Arguments given((int)pointers.size(), pointers.data(), "radiosity --help");
    return readJob(given);
}

// Finds the rows that a job uses, and takes its options from theirs. Throws Refused if they do not belong to
// its model or solution.
std::unique_ptr<KeptRows> findRows(Job &job) {
    if (job.keepRows)
        throw Refused("--keep-rows and --relight do not go together: the rows are kept already");
    if (job.out == job.relight)
        throw Refused("-o names the solution whose rows are used: give the new one another name");
    std::string file = rowsFile(job.relight);
    uint64_t solution = sumOfSolution(job.relight);
    auto kept = std::make_unique<KeptRows>(file);
    if (kept->solution != solution)
        throw Refused(file + ": belongs to another solution than " + job.relight +
                      " is now: solve with --keep-rows again");
    if (kept->model != sumOfFile(job.model))
        throw Refused(file + ": belongs to another model than " + job.model + " is now: solve it again");
    job.options.follow(readJob(kept->words).options, file);
    if (kept->sky != sumOf(job.options.settings.surroundings.sky))
        throw Refused(file +
                      ": belongs to another picture of the sky than there is now: solve the model again");
    return kept;
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

void printRelit(const Solved &solved) {
    const SolveReport &r = solved.report;
    auto seconds = [&](SolveStep step) { return r.seconds[(int)step]; };
    if (solved.patches)
        std::printf("kept rows of %d patches\n", r.patches);
    else
        std::printf("kept rows of %d sites with %zu rays\n", r.sites, r.raysFromSite);
    std::printf("processor seconds: reading %.2f, solving %.2f\n",
                seconds(SolveStep::kDividing) + seconds(SolveStep::kFormFactors),
                seconds(SolveStep::kDirectLight) + seconds(SolveStep::kSolving));
    if (!r.whole)
        std::printf("stopped: the light is that of %d sweeps\n", r.sweeps);
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
    Job job = readJob(state.words);
    checkWritable(job.out);
    return job;
}

// Solves a job; if an even sky lights no front, solves it again with both sides lit.
class SolveCommand {
public:
    SolveCommand(Job job, SolveState state) : job(std::move(job)), state(std::move(state)) {}

    void run(const std::string &resumed) {
        if (!job.relight.empty()) return relight();
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
        if (solved.report.whole && job.keepRows) saveRows(solved);
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
    std::unique_ptr<KeptRows> kept;          // to be used
    std::unique_ptr<PreparedSolve> prepared; // from these; null: the model is divided
    std::string rows, preparedOnes;          // to be kept
    std::string resumedRows;
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
        settings.resumed = resumedRows = std::move(state.rows);
        if (job.keepRows)
            settings.keepRows = [this](std::string found, std::string prepared) {
                rows = std::move(found), preparedOnes = std::move(prepared);
            };
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
        begin();
    }
    void begin() {
        stopAtInterrupt();
        bar = std::make_unique<ProgressBar>(job.progress);
    }

    Solved solve() {
        auto progress = [this](const char *step, float done, float residual) {
            if (step) bar->show(step, done, residual);
        };
        SolveSettings &settings = job.options.settings;
        Solved solved;
        try {
            if (prepared)
                solved = relightModel(mesh, *prepared, kept->evenSky,
                                      {kept->away[0], kept->away[1], kept->away[2]}, settings, workers, &stop,
                                      progress);
            else {
                if (settings.way == Way::kPatches) gl = openGl();
                solved = solveModel(mesh, settings, gl, workers, &stop, progress);
            }
        } catch (const ModelError &e) {
            throw ModelError(job.model + ": " + e.what());
        }
        bar->clear();
        tell(solved.report.notes);
        return solved;
    }

    // Solves with kept rows. If direct light is kept too, polygons are not read.
    void relight() {
        kept = findRows(job);
        SolveSettings &settings = job.options.settings;
        if (size_t bytes = 2 * (kept->rows.size() + kept->prepared.size()); bytes > settings.memory)
            refuseMemory(bytes, settings.memory, "raise it");
        settings.resumed = kept->rows;
        if (!prepare(*kept)) readModel();
        begin();
        Solved solved = solve();
        solved.solution.save(job.out);
        prepared ? printRelit(solved) : printReport(mesh, solved, settings);
    }

    // Whether kept direct light fits the materials: then only these are read.
    bool prepare(const KeptRows &from) {
        if (from.prepared.empty()) return false;
        std::vector<std::string> notes;
        mesh.materials = readMaterialsAgain(job.model, from.names, job.options.read.changes, notes);
        std::vector<int> emitters;
        for (size_t i = 0; i < mesh.materials.size(); ++i) {
            const MeshMaterial &m = mesh.materials[i];
            if (!m.picture.path.empty()) return false;
            if (from.names.used[i] && m.emits[0] + m.emits[1] + m.emits[2] > 0) emitters.push_back((int)i);
        }
        prepared = std::make_unique<PreparedSolve>(from.prepared, mesh.materials.size());
        if (!prepared->fits(emitters)) prepared = nullptr;
        if (prepared) tell(notes);
        return prepared != nullptr;
    }

    // Keeps the rows beside the solution, whose file is there.
    void saveRows(const Solved &solved) {
        KeptRows to;
        to.words = state.words;
        to.model = sumOfFile(job.model), to.sky = sumOf(job.options.settings.surroundings.sky);
        to.solution = sumOfSolution(job.out);
        to.evenSky = solved.evenSky;
        to.names = mesh.names;
        to.away = {solved.away[0], solved.away[1], solved.away[2]};
        to.rows = rows, to.prepared = preparedOnes;
        to.save(rowsFile(job.out));
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
        job.options.settings.resumed = {};
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
