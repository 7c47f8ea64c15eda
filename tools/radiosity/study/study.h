// What all chapters of a study share: the model, its reference, the time they may take, and the page.
#pragma once

#include "tools/radiosity/solve/progress_bar.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/study/page.h"
#include "tools/radiosity/study/places.h"

#include <map>
#include <optional>

namespace odraz {

struct StudySettings {
    std::string model;
    SolveSettings solve; // light from outside and memory, as given; the chapters set the rest
    double minutes = 8;  // that the study may take
    double within = 5;   // percent: the error (rms) within which the cheapest setting is looked for
    bool upIsZ = false;
};

// A whole solution that was measured.
struct MeasuredSolution {
    std::string name, options; // options of `radiosity solve` that give it
    double seconds;            // of the processor
    double wall;
    LightErrors errors;
};

// Thrown when the user interrupts; nothing is left behind.
struct Interrupted : std::runtime_error {
    Interrupted() : runtime_error("interrupted: no page is written") {}
};

class Study {
public:
    // Takes what is prepared; solves the reference. Throws as solveModel() does.
    Study(const StudySettings &settings, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop,
          Page &page, ProgressBar &bar);

    const StudySettings &settings;
    const Mesh &mesh;
    const Gl &gl;
    Workers &workers;
    const int *stop;
    Page &page;
    Solution reference;
    int finalRays = 0; // of its final gather; 0: it has none
    std::optional<Places> places;
    std::vector<MeasuredSolution> measured;
    std::vector<std::string> notes;   // of solutions, each once
    std::vector<std::string> leftOut; // what the time did not allow
    std::vector<std::string> advice;  // what to choose, and why
    double area;                      // of the model

    // --- Time ---
    // A chapter begins: it may take until this share of the time after the reference has passed.
    void chapter(const char *name, double until);
    // How many seconds the chapter has left, and whether some work fits in there.
    double left() const;
    bool fits(double seconds) const { return seconds < left(); }
    // Throws Interrupted.
    void check() const;
    // Shows how far the study has come: by its time. Throws Interrupted.
    void tick();
    // Prints a line.
    void say(const std::string &line);
    // Work without a limit of time: the next solution is this part, 0 .. 1, of all.
    void nextPart(double from, double to) { partFrom = from, partTo = to; }

    // --- Solving ---
    // Settings for solving between patches of about this many elements that are patches, by hemicubes that
    // see the lamps, as in the thesis.
    SolveSettings thesis(int patches, int px) const;
    // Solves, and shows progress. Throws Interrupted.
    Solved solve(const SolveSettings &s);
    // Solves and measures.
    Solved measure(const std::string &name, const std::string &options, const SolveSettings &s);
    // A model divided into about so many patches, without rows: for hemicubes and costs.
    Solved divide(int patches);
    // The same, or one that was made for costs and has about as many; `own` keeps it otherwise.
    const Solved &divided(int patches, Solved &own);
    // About how many patches the model gets if so many are asked for: every polygon has one at least.
    int patchesFor(int asked) const;
    // The wall-clock seconds that dividing takes, and those that a hemicube and its row take.
    double divideSeconds();
    double hemicubeSeconds(int px);

private:
    void show(); // how far it has come

    ProgressBar &bar;
    double began, afterReference = 0, until = 0;
    const char *name = "reference";
    Solved coarse; // divided into kCoarse patches; empty until costs are asked for
    double coarseSeconds = 0;
    std::map<int, double> costs;                   // of hemicubes, by pixels
    double partFrom = 0, partTo = 0, partDone = 0; // partTo 0: the time counts
};

// Processor and wall-clock time since it was made.
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
void studyRasters(Study &study);  // pixels, anti-aliasing, corners
void studyMethods(Study &study);  // gathering, shooting, Gauss-Seidel; passes
void studyDisplay(Study &study);  // flat and interpolated; mappings
void studyElements(Study &study); // uniform and adaptive
void writeSummary(Study &study);  // what to choose

} // namespace odraz
