// The state that all chapters of a study share: the model, its reference, the time limit, and the page.
#pragma once

#include "tools/radiosity/export/render.h"
#include "tools/radiosity/reference/mesh_reference.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/radiosity/study/page.h"

#include <map>

namespace odraz::radiosity {

struct StudySettings {
    std::string model;
    std::string options; // given options that `radiosity solve` has too, each after a blank
    SolveSettings solve; // light from outside and memory as given; chapters set the rest
    double minutes = 8;  // the time limit of the study
    double within = 5;   // percent: the error (rms) allowed for the cheapest setting
    bool upIsZ = false;
};

// A whole solution that was measured.
struct MeasuredSolution {
    std::string name, command; // the `radiosity solve` that gives it
    double seconds;            // of the processor
    double wall;
    MeshErrors errors;
};

// A whole solution with a hemicube in the middle of each patch.
struct Gathered {
    int px = 0;
    Solution solution;
    MeasuredSolution measured;
    int patches = 0;
};

// The reference's errors against path tracing, which shares neither its rays nor its elements.
struct ReferenceErrors {
    std::string unknown;       // why they are unknown; empty: they are known
    size_t places = 0;         // that sent out paths
    int paths = 0;             // from each
    MeshErrors reference = {}; // of the reference
    MeshErrors byRays = {};    // of the tool's default, at the same places
};

// Thrown when the user interrupts.
struct Interrupted : std::runtime_error {
    Interrupted() : runtime_error("interrupted: no page is written") {}
};

class Study {
public:
    // Solves the reference. Throws as solveModel() does.
    Study(const StudySettings &settings, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop,
          Page &page, ProgressBar &bar);

    const StudySettings &settings;
    const Mesh &mesh;
    const Gl &gl;
    Workers &workers;
    const int *stop;
    Page &page;
    Solution reference;
    int finalRays = 0; // of its final gather; 0: no final gather
    ReferenceErrors referenceErrors;
    std::vector<MeshProbe> traced; // places with their light by path tracing; empty if unknown
    std::vector<MeshProbe> places; // at which solutions are compared with the reference
    std::vector<MeasuredSolution> measured;
    Gathered gathered;                // of the first chapter, if there was time
    std::vector<std::string> notes;   // of solutions, each once
    std::vector<std::string> leftOut; // measurements for which there was no time
    std::vector<std::string> advice;  // recommendations, with reasons
    double area;                      // of the model

    // --- Time --- Begins a chapter, which ends when this share of the time after the reference has passed.
    void chapter(const char *name, double until);
    // The seconds left to the chapter, and whether they are enough for work of this length.
    double left() const;
    bool fits(double seconds) const { return seconds < left(); }
    // Throws Interrupted.
    void check() const;
    // Shows the progress of the study, by its time. Throws Interrupted.
    void tick();
    void print(const std::string &line);
    // The camera for pictures of the model, with their size.
    RenderSettings camera() const;
    // For work without a time limit: the next solution is this part, 0 .. 1, of the work.
    void nextPart(double from, double to) { partFrom = from, partTo = to; }

    // --- Solving --- Settings for solving as in the thesis: about `patches` patches of one element each, and
    // hemicubes that see the lamps.
    SolveSettings thesis(int patches, int px) const;
    // Solves, and shows progress. Throws Interrupted.
    Solved solve(const SolveSettings &s);
    // The errors of a solution, against the reference.
    MeshErrors errorsOf(const Solution &solution) const;
    // Solves and measures. `options`: those of `radiosity solve` for this solution. Its name is the number of
    // patches, if their hemicubes see the lamps, or of elements, followed by `kind`.
    Solved measure(const std::string &kind, const std::string &options, const SolveSettings &s);
    // Solves thesis(patches, px), and measures.
    Solved gather(int patches, int px);
    // The model divided into about this number of patches, without rows: for hemicubes and costs.
    Solved divide(int patches);
    // The same, in `own`; or the division made for costs, if it has about this number of patches.
    const Solved &divided(int patches, Solved &own);
    // About the number of patches that the model gets if `asked` are asked for: every polygon has at least
    // one.
    int patchesFor(int asked) const;
    // The wall-clock seconds that dividing takes, and those that a hemicube and its row take.
    double divideSeconds();
    double hemicubeSeconds(int px);

private:
    std::string command(const std::string &options) const;
    void compare(const Solution &byRays, const Surroundings &around); // with path tracing
    void show();                                                      // progress

    ProgressBar &bar;
    double began, afterReference = 0, until = 0;
    const char *name = "reference";
    Solved coarse; // divided into kCoarse patches; empty until costs are asked for
    double coarseSeconds = 0;
    std::map<int, double> costs;                   // seconds of a hemicube, by pixels
    double partFrom = 0, partTo = 0, partDone = 0; // partTo 0: progress is by time
};

// Processor and wall-clock seconds since its construction.
struct Stopwatch {
    Stopwatch();
    double processor() const;
    double wall() const;

private:
    double startProcessor, startWall;
};

// The chapters, in their order. Each writes to the page.
// Three sizes by three rasters; `ofThesis`: those of its Table 4.1.
void studyTable(Study &study, bool ofThesis);
void studyRasters(Study &study); // pixels, anti-aliasing, corners
void studyMethods(Study &study); // gathering, shooting, Gauss-Seidel; passes
void studyDisplay(Study &study); // flat and interpolated; mappings
void writeSummary(Study &study); // recommendations

} // namespace odraz::radiosity
