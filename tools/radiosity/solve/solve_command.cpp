#include "tools/radiosity/solve/solve_command.h"

#include "tools/engine/machine.h"
#include "tools/radiosity/solution/memory.h"
#include "tools/radiosity/solve/progress_bar.h"
#include "tools/radiosity/solve/scaled.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/solve_job.h"
#include "tools/radiosity/solve/solve_report.h"
#include "tools/radiosity/solve/terminal.h"

#include <cstdio>

namespace odraz::radiosity {

namespace {

int stop = 0; // becomes 1 with Ctrl-C

// Whether the even sky, which is added if nothing else emits, cannot get in: the model is closed and its
// fronts face inwards.
bool staysDark(const Solution &b) {
    double light = 0;
    for (const Rgb &c : b.emits)
        if (maxComponent(c) > 0) return false;
    for (const Rgb &c : b.light) light += (double)(c.x + c.y + c.z);
    return light < 0.01 * (double)b.light.size();
}

// Solves a job; if an even sky lights no front, solves it again with both sides lit.
class SolveCommand {
public:
    SolveCommand(SolveJob &job, SolveState state) : job(job), state(std::move(state)) {}

    void run() {
        if (!job.relight.empty()) return relight();
        read();
        if (!job.resume.empty() && modelSum != state.model)
            throw common::Refused(job.resume + ": belongs to another model than " + job.model +
                                  " is now: solve it again");
        state.model = modelSum;
        prepare();
        Solved solved = solve();
        if (mayLightBacks() && solved.report.whole && staysDark(solved.solution)) {
            printNotes({"no light reaches the fronts of the polygons: both sides are lit (--two-sided)"});
            lightBacks();
            solved = {};
            solved = solve();
        }
        solved.solution.save(job.out);
        if (solved.report.whole && job.keepRows) saveRows(solved);
        if (solved.report.whole) std::remove(stateFile().c_str());
        printReport(mesh, solved, job.options.settings);
        if (!solved.report.whole && job.options.settings.shots == 0)
            std::printf("to continue: radiosity solve --resume %s\n", stateFile().c_str());
    }

private:
    SolveJob &job;
    SolveState state;
    Mesh mesh;
    uint64_t modelSum = 0;
    std::unique_ptr<KeptRows> kept;          // to be used
    std::unique_ptr<PreparedSolve> prepared; // from these; null: the model is divided
    std::string rows, preparation;           // to be kept
    std::string resumedRows;
    Workers workers = allProcessors();
    Gl gl = {};
    std::unique_ptr<ProgressBar> bar;

    std::string stateFile() const { return job.out + ".state"; }

    void read() {
        std::vector<std::string> notes;
        mesh = readModel(job.model, job.options.read, notes);
        printNotes(notes);
        modelSum = sumOf(mesh, job.options.settings.surroundings.sky);
    }

    void prepare() {
        SolveSettings &settings = job.options.settings;
        settings.resumed = resumedRows = std::move(state.rows);
        if (job.keepRows)
            settings.keepRows = [this](std::string found, std::string prepared) {
                rows = std::move(found), preparation = std::move(prepared);
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
        stopAt(stop, {SIGINT});
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
        printNotes(solved.report.notes);
        return solved;
    }

    // Solves with kept rows. If direct light is kept too, polygons are not read.
    void relight() {
        kept = findRows(job);
        SolveSettings &settings = job.options.settings;
        if (size_t bytes = 2 * (kept->rows.size() + kept->prepared.size()); bytes > settings.memory)
            refuseMemory(bytes, settings.memory, "raise it");
        settings.resumed = kept->rows;
        if (!prepare(*kept)) {
            read();
            bool dark = !shines(mesh) && !settings.surroundings.shine();
            if (dark && settings.evenSky && !kept->evenSky) refuseDark();
        }
        if (prepared && job.options.stopsAlike && !kept->evenSky) {
            Solution scaled(job.relight);
            if (scaleLight(scaled, mesh, *prepared, settings)) {
                scaled.save(job.out);
                std::printf("kept light, scaled: all lamps changed alike\n");
                return;
            }
        }
        begin();
        Solved solved = solve();
        solved.solution.save(job.out);
        prepared ? printRelit(solved, settings) : printReport(mesh, solved, settings);
        if (!solved.report.whole) std::printf("for all of its light run it again: the rows are kept\n");
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
        if (prepared) printNotes(notes);
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
        to.rows = rows, to.prepared = preparation;
        to.save(rowsFile(job.out));
    }

    bool mayLightBacks() const {
        const SolveSettings &settings = job.options.settings;
        return settings.evenSky && !settings.surroundings.shine() && !job.options.read.twoSided;
    }
    void lightBacks() {
        job.options.read.twoSided = true;
        std::vector<std::string> known; // notes that were printed already
        mesh = readModel(job.model, job.options.read, known);
        state.words.push_back("--two-sided"); // for --resume
        state.model = sumOf(mesh, job.options.settings.surroundings.sky);
        job.options.settings.resumed = {};
    }
};

} // namespace

int runSolve(common::CommandLine &line) {
    SolveState state;
    std::unique_ptr<SolveJob> job = beginJob(line.words(), state);
    SolveCommand(*job, std::move(state)).run();
    return 0;
}

} // namespace odraz::radiosity
