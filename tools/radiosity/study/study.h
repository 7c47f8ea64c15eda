// The state that all chapters of a study share: the model, its reference, and the page. The errors that they
// measure do not depend on the machine, so pages of two machines can be compared.
#pragma once

#include "tools/common/clock.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/reference/mesh_reference.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/radiosity/study/page.h"
#include "tools/support/machine.h"

namespace odraz::radiosity {

struct StudySettings {
    std::string model;
    std::string options; // the given options that `radiosity solve` also has, each after a blank
    SolveSettings solve; // light from outside and memory as given; the chapters set the rest
    bool quick = false;  // only the smaller sizes and rasters, and fewer patches, shots and rays
    bool upIsZ = false;
    int tasks = 0;                                     // number of solutions and gathers of all chapters
    int finalRays() const { return quick ? 64 : 256; } // rays of the final gather
};

// Measures processor and wall-clock seconds since its construction.
struct Stopwatch {
    double processor() const { return common::processorSeconds() - startProcessor; }
    double wall() const { return common::wallSeconds() - startWall; }

private:
    double startProcessor = common::processorSeconds(), startWall = common::wallSeconds();
};

// A solution with its cost and errors.
struct MeasuredSolution {
    std::string name, command; // `command`: the `radiosity solve` that produces it
    double seconds;            // processor time
    double wall;               // wall-clock time, seconds
    MeshErrors errors;
};

// Thrown when the user interrupts.
struct Interrupted : std::runtime_error {
    Interrupted() : runtime_error("interrupted: no page is written") {}
};

class Study {
public:
    // Solves the reference. Throws as solveModel() does.
    Study(const StudySettings &settings, const Mesh &mesh, Page &page, bool progress);

    const StudySettings &settings;
    const Mesh &mesh;
    Page &page;
    const int *const stop = stopAt({SIGINT, SIGTERM});
    const Gl gl = openGl();
    Workers workers = allProcessors();
    Solution reference;
    std::string referenceText;     // its errors against path tracing
    std::vector<MeshProbe> places; // where solutions are compared with the reference
    std::vector<MeasuredSolution> measured;
    std::vector<std::string> notes;   // the solutions' notes, each once
    std::vector<std::string> leftOut; // chapters that were interrupted
    double area = areaOf(mesh);

    // Throws Interrupted if the user interrupted.
    void check() const;
    // Begins a chapter.
    void chapter(const char *named) { name = named; }
    // Shows that one more task is done. Throws Interrupted.
    void taskDone();
    void print(const std::string &line); // instead of the progress bar
    // The camera and the size for pictures of the model.
    RenderSettings camera() const;

    // The thesis's settings: about `patches` patches of one element each, and hemicubes that see the lamps.
    SolveSettings thesis(int patches, int px) const;
    // Solves and shows progress. Throws Interrupted.
    Solved solve(const SolveSettings &s);
    // The errors of a solution against the reference.
    MeshErrors errorsOf(const Solution &solution) const;
    // Solves thesis(patches, px) and adds it to `measured`. `shots`: shoot light with at most this number of
    // hemicubes; 0: find rows.
    Solved measure(int patches, int px, int shots = 0);

private:
    std::string command(const std::string &options) const;
    void comparePaths(const Solution &byRays, const Surroundings &surroundings); // sets referenceText
    void show(float part); // shows the share of the current task that is done

    ProgressBar bar;
    const char *name = "reference";
    int done = 0, tasks; // tasks of the whole study
};

// The eye of a hemicube near corner k of a patch, a tenth of a side inside it. If the patch is partly hidden,
// the eye is in its middle.
Eye cornerEye(const Model &model, int patch, int k);

// The chapters. Each writes to the page.
void studyTable(Study &study, bool ofThesis); // sizes by rasters; `ofThesis`: the thesis's Table 4.1
void studyRasters(Study &study);              // pixels, anti-aliasing, corners
void studyMethods(Study &study);              // gathering, shooting, Gauss-Seidel; passes
void studyDisplay(Study &study);              // flat and interpolated; mappings
void writeSummary(Study &study);              // the reference; the best solutions

} // namespace odraz::radiosity
