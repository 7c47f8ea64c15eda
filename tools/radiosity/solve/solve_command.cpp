#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/solution/saved_state.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/solve_options.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/support/machine.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

namespace odraz::radiosity {

namespace {

struct SolveJob {
    std::string model, out, resume; // resume: the file of a saved state to continue from
    double keepEvery = 60;          // seconds
    bool keeps = false;             // OUT is a file, not a device, so OUT.state can be written next to it
    SolveOptions options;
    std::optional<SavedState> saved; // read from `resume`
    std::string state() const { return out + ".state"; }
};

// Reads the command line, or with --resume the one in the saved state. Throws Refused.
void readSolveJob(common::CommandLine &line, SolveJob &job) {
    line.about("Computes the light in a model and writes it to OUT, a solution for the other commands.\n"
               "Ctrl-C stops early and writes the light found so far; by rays, also OUT.state.");
    line.argument("MODEL", job.model,
                  "a Wavefront OBJ or glTF. Polygons are lit on the side from which their points run "
                  "counter-clockwise. Materials reflect light (Kd, map_Kd) and emit it (Ke, map_Ke)",
                  false);
    line.option("-o", "OUT", job.out, "the file of the solution");
    line.option("--resume", "OUT.state", job.resume,
                "continue a stopped run with its options, to the same result; takes no other option");
    line.option("--keep-every", "S", job.keepEvery, {0.01, 1e9}, "by rays: write OUT.state every S seconds");
    job.options.addTo(line, SolveOptions::For::kSolve);
    line.parse();
    if (!job.resume.empty() && !job.saved) {
        common::need(line.given().size() == 1 && job.model.empty(),
                     "--resume takes no other option: it continues with the original ones");
        job.saved.emplace(job.resume);
        common::CommandLine original("radiosity solve", job.saved->words);
        return readSolveJob(original, job);
    }
    common::need(!job.model.empty(), "name a model: radiosity solve MODEL.obj -o OUT");
    common::need(!job.out.empty(), "name a file for the solution with -o OUT");
    job.options.finish(line);
    if ((job.keeps = claimOutput(job.out))) common::claimOutput(job.state());
}

// Whether the polygons' fronts stay dark: the only light is an even sky, outside a closed model.
bool staysDark(const Solution &b) {
    double light = 0;
    for (const Rgb &c : b.emits)
        if (maxComponent(c) > 0) return false;
    for (const Rgb &c : b.light) light += (double)(c.x + c.y + c.z);
    return light < 0.01 * (double)b.light.size();
}

void printSolveReport(const Mesh &mesh, const Solved &solved, const SolveSettings &settings) {
    const SolveReport &r = solved.report;
    bool byRays = !solved.patches;
    auto seconds = [&](SolveStep step) { return r.seconds[(int)step]; };
    auto counted = [](auto count, const char *what) { return common::counted((size_t)count, what); };
    const std::string elements = counted(solved.solution.elements(), "element");
    std::printf("%s, %s in one plane each; ", counted(mesh.triangles.size(), "triangle").c_str(),
                counted(solved.solution.charts.size(), "polygon").c_str());
    if (byRays)
        std::printf("%s; %s (their corners) with %s\n", elements.c_str(), counted(r.sites, "site").c_str(),
                    counted(r.raysFromSite, "ray").c_str());
    else
        std::printf("%s, %s\n", counted(r.patches, "patch").c_str(), elements.c_str());
    std::printf("processor seconds: dividing %.2f, form factors %.2f", seconds(SolveStep::kDividing),
                seconds(SolveStep::kFormFactors));
    if (!byRays) std::printf(" (%s)", counted(r.rows + r.shots, "hemicube").c_str());
    std::printf(", direct light %.2f, solving %.2f\n", seconds(SolveStep::kDirectLight),
                seconds(SolveStep::kSolving));
    if (r.shots > 0)
        std::printf("%s, %.2g %% of the light is not shot%s\n", counted(r.shots, "shot").c_str(),
                    100 * (double)r.residual, r.complete ? "" : ": stopped");
    else if (!r.complete && r.sweeps > 0)
        std::printf("stopped: the light of %s\n", counted(r.sweeps, "sweep").c_str());
    else if (!r.complete)
        std::printf("stopped: direct light, and the rows of %s\n",
                    counted(r.rows, byRays ? "site" : "patch").c_str());
    else if (settings.bounces >= 0)
        std::printf("%s\n", counted(r.sweeps, "bounce").c_str());
    else
        std::printf("%s, residual %.1e\n", counted(r.sweeps, "sweep").c_str(), (double)r.residual);
}

// Prints the mean radiosity, emission included, of the materials with the largest areas.
void printMeans(const Solution &solution) {
    constexpr size_t kMost = 12;
    std::map<std::string, PieceSum> sums;
    double area = 0;
    solution.forPieces([&](int chart, int, const std::vector<SolutionPoint> &piece) {
        sums[solution.materialOf(chart)].add(piece);
    });
    std::vector<std::pair<std::string, PieceSum>> all(sums.begin(), sums.end());
    for (const auto &[name, sum] : all) area += sum.area;
    std::stable_sort(all.begin(), all.end(),
                     [](const auto &a, const auto &b) { return a.second.area > b.second.area; });
    std::printf("material             of the area   mean radiosity: red, green, blue\n");
    for (size_t i = 0; i < std::min(all.size(), kMost); ++i) {
        const auto &[name, sum] = all[i];
        Vec3d mean = sum.radiosity / sum.area;
        std::printf("%-20.40s %9.1f %%   %.4g %.4g %.4g\n", name.c_str(), 100 * sum.area / area, mean.x,
                    mean.y, mean.z);
    }
    if (all.size() > kMost) std::printf("... and %zu more\n", all.size() - kMost);
}

// Solves a model. If an even sky lights no front, solves it again with both sides lit.
class SolveCommand {
public:
    SolveCommand(SolveJob &job, const std::vector<std::string> &words) : job(job) { state.words = words; }

    void run() {
        // Print the notes only when nothing can be refused any more, because a refusal prints one line
        std::vector<std::string> notes;
        read(notes);
        job.options.addLights(mesh, settings.surroundings, notes);
        common::need(!job.saved || job.saved->model == state.model,
                     job.resume + ": belongs to another model, or " + job.model +
                         " has changed: solve the model again");
        printNotes(notes);
        prepare();
        Solved solved = solve();
        std::vector<std::string> &found = solved.report.notes;
        bool mayLightBacks = settings.evenSky && !settings.surroundings.any() && !job.options.read.twoSided;
        if (mayLightBacks && solved.report.complete && staysDark(solved.solution)) {
            std::erase(found, kDarkNote);
            found.emplace_back(
                "no light reaches the fronts of the polygons: both sides are lit (--two-sided)");
            printNotes(found);
            job.options.read.twoSided = true;
            read(notes);                          // finds the same notes, which are printed
            state.words.push_back("--two-sided"); // for --resume
            settings.saving.resumed = {};
            solved = {};
            solved = solve();
        }
        printNotes(found);
        solved.solution.save(job.out);
        if (solved.report.complete && job.keeps) std::remove(job.state().c_str());
        printSolveReport(mesh, solved, settings);
        printMeans(solved.solution);
        if (!solved.report.complete && !solved.patches && job.keeps)
            std::printf("to continue: radiosity solve --resume %s\n", job.state().c_str());
    }

private:
    SolveJob &job;
    SolveSettings &settings = job.options.settings;
    SavedState state; // written next to the solution
    Mesh mesh;
    Workers workers = allProcessors();
    Gl gl = {};
    const int *stop = nullptr;
    ProgressBar bar{job.options.progress};

    void read(std::vector<std::string> &notes) {
        mesh = readModel(job.model, job.options.read, notes);
        state.model = sumOf(mesh, settings.surroundings.sky);
    }

    void prepare() {
        if (job.saved) settings.saving.resumed = job.saved->rows;
        settings.saving.seconds = job.keepEvery;
        if (job.keeps)
            settings.saving.save = [this](const std::string &rows) {
                state.rows = rows;
                state.save(job.state());
            };
        settings.needs = [this](size_t bytes) {
            bar.clear();
            std::printf("needs about %zu MB of memory\n", bytes >> 20);
            std::fflush(stdout);
        };
        stop = stopAt({SIGINT});
    }

    Solved solve() {
        auto progress = [this](auto... shown) { bar.show(shown...); };
        Solved solved = solveNamed(job.model, [&] {
            if (settings.method == SolveMethod::kPatches) gl = openGl();
            return solveModel(mesh, settings, gl, workers, stop, progress);
        });
        bar.clear();
        return solved;
    }
};

} // namespace

int runSolve(common::CommandLine &line) {
    SolveJob job;
    readSolveJob(line, job);
    SolveCommand(job, job.saved ? job.saved->words : line.words()).run();
    return 0;
}

} // namespace odraz::radiosity
