// The state that all chapters of a study share: the model, its reference, and the page. What they
// measure does not depend on time, so pages of two machines can be compared.
#pragma once

#include "tools/radiosity/export/render.h"
#include "tools/radiosity/reference/mesh_reference.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/radiosity/study/page.h"

namespace odraz::radiosity {

struct StudySettings {
    std::string model;
    std::string options; // given options that `radiosity solve` has too, each after a blank
    SolveSettings solve; // light from outside and memory as given; chapters set the rest
    bool quick = false;  // only the smaller sizes and rasters, and fewer patches, shots and rays
    bool upIsZ = false;
};

// A whole solution that was measured.
struct MeasuredSolution {
    std::string name, command; // the `radiosity solve` that gives it
    double seconds;            // processor time
    double wall;
    MeshErrors errors;
};

inline constexpr int kFinalRays = 256; // rays of the reference's final gather; a quick study has none

// The reference's errors against path tracing, which shares neither its rays nor its elements.
struct ReferenceErrors {
    std::string unknown;       // why they are unknown; empty: they are known
    size_t places = 0;         // places that sent out paths
    int paths = 0;             // paths from each place
    MeshErrors reference = {}; // the reference's errors
    MeshErrors byRays = {};    // errors of the tool's default, at the same places
};

// Thrown when the user interrupts.
struct Interrupted : std::runtime_error {
    Interrupted() : runtime_error("interrupted: no page is written") {}
};

class Study {
public:
    // Solves the reference. `tasks`: the number of solutions and gathers of all chapters. Throws as
    // solveModel() does.
    Study(const StudySettings &settings, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop,
          Page &page, ProgressBar &bar, int tasks);

    const StudySettings &settings;
    const Mesh &mesh;
    const Gl &gl;
    Workers &workers;
    const int *stop;
    Page &page;
    Solution reference;
    ReferenceErrors referenceErrors;
    std::vector<MeshProbe> places; // at which solutions are compared with the reference
    std::vector<MeasuredSolution> measured;
    std::vector<std::string> notes;   // the solutions' notes, each once
    std::vector<std::string> leftOut; // chapters that were interrupted
    double area;                      // the model's

    // Throws Interrupted.
    void check() const;
    // Begins a chapter.
    void chapter(const char *named) { name = named; }
    // Shows that another of the tasks is done. Throws Interrupted.
    void taskDone();
    void print(const std::string &line);
    // The camera for pictures of the model, with their size.
    RenderSettings camera() const;

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
    // The model divided into about this number of patches, without rows.
    Solved divide(int patches);

private:
    std::string command(const std::string &options) const;
    void compare(const Solution &byRays, const Surroundings &around); // with path tracing
    void show(float part);                                            // the progress of the current work

    ProgressBar &bar;
    const char *name = "reference";
    int done = 0, tasks; // the tasks of the whole study
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
// Sizes by rasters; `ofThesis`: those of its Table 4.1.
void studyTable(Study &study, bool ofThesis);
void studyRasters(Study &study); // pixels, anti-aliasing, corners
void studyMethods(Study &study); // gathering, shooting, Gauss-Seidel; passes
void studyDisplay(Study &study); // flat and interpolated; mappings
void writeSummary(Study &study); // the reference; the best solutions

} // namespace odraz::radiosity
