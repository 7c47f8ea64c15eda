// bench_radiosity: times whole solutions of models as large as those in table 4.1 of the thesis.
#include "tools/common/command_line.h"
#include "tools/common/statistics.h"
#include "tools/engine/machine.h"
#include "tools/measure/oracle/generated_mesh.h"
#include "tools/radiosity/generate/generate.h"
#include "tools/radiosity/reference/mesh_reference.h"
#include "tools/radiosity/solve/solve.h"

#include <cmath>
#include <cstdio>

namespace odraz::measure {

using namespace radiosity;

namespace {

// Table 4.1 of the thesis: triangles, and seconds at 100 x 100 pixels.
struct ThesisRow {
    size_t triangles;
    double seconds;
};
constexpr ThesisRow kThesis[] = {{26360, 280}, {136512, 3500}, {546048, 34980}};

// The largest area of a triangle that gives a model at least `triangles` triangles, and at most 0.5 % more
// where its steps allow that. Curved models get about as many.
double areaFor(const std::string &kind, size_t triangles) {
    if (kind == "vault") return 27600 * 0.06 / (double)triangles;
    if (kind == "terrain") return 27400 * 0.02 / (double)triangles;
    double low = 1e-4, high = 10;
    for (int i = 0; i < 40; ++i) {
        double middle = std::sqrt(low * high);
        size_t count = 0;
        generateObj(kind, middle, &count);
        if (count >= triangles && (double)count < 1.005 * (double)triangles) return middle;
        (count >= triangles ? low : high) = middle;
    }
    return low;
}

// Prints a row of the table. `thesis`: the seconds of the thesis, 0 if it has none. `small`: print the median
// time of three rounds and the errors; otherwise the time of one round.
void printRow(const char *name, const Mesh &mesh, const SolveSettings &settings, double thesis, bool small,
              const Gl &gl, Workers &workers) {
    std::vector<double> times;
    Solved solved;
    for (int round = 0; round < (small ? 3 : 1); ++round) {
        solved = {}; // frees the memory of the round before
        solved = solveModel(mesh, settings, gl, workers, &kNever, {});
        times.push_back(solved.report.allSeconds);
    }
    std::printf("| %s | %zu | %zu | %d | %zu |", name, mesh.triangles.size(), solved.solution.elements(),
                solved.report.sites, solved.report.raysFromSite);
    if (thesis > 0) std::printf(" %.0f", thesis);
    std::printf(" | %.2f | %.2f |", common::median(times),
                common::median(times) * 1e6 / (double)mesh.triangles.size());
    if (small) {
        auto probes = placeMeshProbes(solved.solution, 1000);
        tracePaths(mesh, solved.surroundings, probes, 64, workers);
        MeshErrors e = errorsOf(probes);
        std::printf(" %.2f | %.2f |", e.median, e.rms);
    }
    std::printf("\n");
    std::fflush(stdout);
}

int run(common::CommandLine &line) {
    line.about("Times whole solutions of radiosity. Prints a table in Markdown.");
    line.parse();
    Gl gl = openGl();
    Workers workers = allProcessors();
    std::printf("| model | triangles | elements | sites | rays from each | the thesis, s | odraz, s "
                "| us a triangle | median of 1,000 places, %% | rms, %% "
                "|\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (const ThesisRow &row : kThesis) {
        Mesh mesh = generatedMesh("columns", areaFor("columns", row.triangles));
        SolveSettings s;
        // At least as many elements as triangles
        s.element = areaOf(mesh) / (double)row.triangles / 1.1;
        s.memory = (size_t)8 << 30;
        printRow("columns", mesh, s, row.seconds, row.triangles < 30000, gl, workers);
    }
    // In these models few triangles lie in one plane
    printRow("cave", generatedMesh("cave", areaFor("cave", 26000)), {}, 0, false, gl, workers);
    for (const char *kind : {"vault", "terrain"})
        printRow(kind, generatedMesh(kind, areaFor(kind, 30000)), {}, 0, true, gl, workers);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) {
    return common::runProgram("bench_radiosity", argc, argv, odraz::measure::run);
}
