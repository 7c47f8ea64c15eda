#include "tools/common/command_line.h"
#include "tools/engine/machine.h"
#include "tools/radiosity/solution/memory.h"
#include "tools/radiosity/solve/scaled.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/solve_job.h"
#include "tools/radiosity/solve/solve_report.h"
#include "tools/radiosity/solve/terminal.h"

#include <cstdio>

namespace odraz::radiosity {

namespace {

int stop = 0; // becomes 1 with Ctrl-C

// Whether the even sky, which is added if nothing else emits, reaches no front: the model is closed and its
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
    explicit SolveCommand(SolveJob &job) : job(job) {
        toKeep.words = job.kept && job.relight.empty() ? job.kept->words : job.line.words();
    }

    void run() {
        if (!job.relight.empty()) return relight();
        const std::vector<std::string> notes = read();
        toKeep.model = modelSum();
        if (job.kept && job.kept->model != toKeep.model)
            throw common::Refused(job.resume + ": belongs to another model, or " + job.model +
                                  " has changed: solve it again");
        printNotes(notes);
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
    Kept toKeep; // the data written beside the solution
    Mesh mesh;
    std::unique_ptr<PreparedSolve> prepared; // from kept rows; null: the model is divided
    std::string rows, preparation;           // of the whole solution, for OUT.rows
    Workers workers = allProcessors();
    Gl gl = {};
    std::unique_ptr<ProgressBar> bar;

    std::string stateFile() const { return job.out + ".state"; }

    // Returns the notes: they are printed once nothing is refused, so that a refusal stays one line.
    std::vector<std::string> read() {
        std::vector<std::string> notes;
        mesh = readModel(job.model, job.options.read, notes);
        job.options.addLights(mesh, job.options.settings.surroundings, notes);
        return notes;
    }
    uint64_t modelSum() const { return sumOf(mesh, job.options.settings.surroundings.sky); }

    void prepare() {
        SolveSettings &settings = job.options.settings;
        if (job.kept) settings.resumed = job.kept->rows;
        if (job.keepRows)
            settings.keepRows = [this](std::string found, std::string prepared) {
                rows = std::move(found), preparation = std::move(prepared);
            };
        settings.keepEvery = job.keepEvery;
        settings.keep = [this](const std::string &rows) {
            toKeep.rows = rows;
            toKeep.save(stateFile(), Kept::Kind::kState);
        };
        settings.needs = [](size_t bytes) {
            std::printf("needs about %zu MB of memory\n", bytes >> 20);
            std::fflush(stdout);
        };
        begin();
    }
    void begin() {
        stopAt(stop, {SIGINT});
        bar = std::make_unique<ProgressBar>(job.options.progress);
    }

    Solved solve() {
        auto progress = [this](const char *step, float done, float residual) {
            if (step) bar->show(step, done, residual);
        };
        SolveSettings &settings = job.options.settings;
        Solved solved = solveNamed(job.model, [&] {
            if (prepared) {
                return relightModel(mesh, *prepared, job.kept->evenSky, settings, workers, &stop, progress);
            }
            if (settings.way == Way::kPatches) gl = openGl();
            return solveModel(mesh, settings, gl, workers, &stop, progress);
        });
        bar->clear();
        printNotes(solved.report.notes);
        return solved;
    }

    // Solves with kept rows. If direct light is kept too, polygons are not read.
    void relight() {
        const Kept &kept = *job.kept;
        SolveSettings &settings = job.options.settings;
        if (size_t bytes = 2 * (kept.rows.size() + kept.prepared.size()); bytes > settings.memory)
            refuseMemory(bytes, settings.memory, "raise it");
        settings.resumed = kept.rows;
        if (!prepare(kept)) {
            const std::vector<std::string> notes = read();
            bool dark = !emitsLight(mesh) && !settings.surroundings.any();
            if (dark && settings.evenSky && !kept.evenSky) refuseDark();
            printNotes(notes);
        }
        if (prepared && job.options.stopsAlike && !kept.evenSky) {
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
        if (!solved.report.whole) std::printf("run it again to find all of its light: the rows are kept\n");
    }

    // Whether kept direct light fits the materials; if so, only materials are read.
    bool prepare(const Kept &from) {
        if (from.prepared.empty()) return false;
        std::vector<std::string> notes;
        mesh.place = from.place[0];
        mesh.materials = readMaterialsAgain(job.model, from.names, job.options.read.changes, notes);
        std::vector<int> emitters;
        for (size_t i = 0; i < mesh.materials.size(); ++i) {
            const MeshMaterial &m = mesh.materials[i];
            if (!m.picture.path.empty() || !m.glow.path.empty()) return false;
            if (from.names.used[i] && m.emits[0] + m.emits[1] + m.emits[2] > 0) emitters.push_back((int)i);
        }
        prepared = std::make_unique<PreparedSolve>(from.prepared, mesh.materials.size());
        if (!prepared->fits(emitters)) prepared = nullptr;
        if (prepared) printNotes(notes);
        return prepared != nullptr;
    }

    // Writes the rows beside the solution, which is already written.
    void saveRows(const Solved &solved) {
        toKeep.model = sumOfFile(job.model, mesh.names.parts),
        toKeep.sky = sumOf(job.options.settings.surroundings.sky);
        toKeep.solution = sumOfSolution(job.out);
        toKeep.evenSky = solved.evenSky;
        toKeep.names = mesh.names;
        toKeep.place = {mesh.place};
        toKeep.rows = rows, toKeep.prepared = preparation;
        toKeep.save(rowsFile(job.out), Kept::Kind::kRows);
    }

    bool mayLightBacks() const {
        const SolveSettings &settings = job.options.settings;
        return settings.evenSky && !settings.surroundings.any() && !job.options.read.twoSided;
    }
    void lightBacks() {
        job.options.read.twoSided = true;
        std::vector<std::string> known; // notes already printed
        mesh = readModel(job.model, job.options.read, known);
        toKeep.words.push_back("--two-sided"); // for --resume
        toKeep.model = modelSum();
        job.options.settings.resumed = {};
    }
};

} // namespace

int runSolve(common::CommandLine &line) {
    std::unique_ptr<SolveJob> job = readJob(line.words());
    SolveCommand(*job).run();
    return 0;
}

} // namespace odraz::radiosity
