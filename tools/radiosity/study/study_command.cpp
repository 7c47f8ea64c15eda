#include "tools/radiosity/study/study_command.h"

#include "tools/common/clock.h"
#include "tools/common/machine.h"
#include "tools/common/temporary_folder.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/generate/generate.h"
#include "tools/radiosity/solve/solve_options.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/radiosity/study/study.h"

#include <cstdio>

namespace odraz {

namespace {

int stop = 0; // becomes 1 with Ctrl-C

struct Job {
    StudySettings settings;
    std::string out;
    bool table41 = false, progress = false;
    SolveOptions options;
};

Job readJob(Arguments &words) {
    Job job;
    while (const char *word = words.next()) {
        std::string w = word;
        // What the study varies itself is not to be set
        bool varied = w == "--rays" || w == "--final" || w == "--element" || w == "--hemicube" ||
                      w == "--patch" || w == "--adaptive" || w == "--direct" || w == "--bounces" ||
                      w == "--shots";
        if (varied)
            throw Refused(w + " is what a study varies: leave it out");
        else if (w == "-o")
            job.out = words.value(w);
        else if (w == "--minutes")
            job.settings.minutes = words.number(w, 0.1, 10000);
        else if (w == "--within")
            job.settings.within = words.number(w, 0.01, 100);
        else if (w == "--table41")
            job.table41 = true;
        else if (w == "--progress")
            job.progress = true;
        else if (job.options.take(w, words))
            continue;
        else if (word[0] != '-' && job.settings.model.empty())
            job.settings.model = w;
        else
            words.refuse(w);
    }
    if (job.table41 != job.settings.model.empty())
        throw Refused(job.table41 ? "--table41 takes no model: it generates the hall of columns"
                                  : "name a model: radiosity study MODEL.obj -o FOLDER");
    if (job.out.empty()) throw Refused("name a folder for the page with -o FOLDER");
    job.options.finish();
    job.settings.solve = job.options.settings;
    job.settings.upIsZ = job.options.upIsZ;
    return job;
}

Mesh columns() {
    TemporaryFolder folder;
    writeWhole(folder / "columns.mtl", generateMtl());
    writeWhole(folder / "columns.obj", "mtllib columns.mtl\n" + generateObj("columns", 0));
    std::vector<std::string> notes;
    return readObj(folder / "columns.obj", {}, notes);
}

void runChapters(Study &study) {
    // The methods first: they need all rows, which take longest in a model of many polygons
    study.chapter("methods", 0.45);
    studyMethods(study);
    study.chapter("table", 0.65);
    studyTable(study, false);
    study.chapter("rasters", 0.85);
    studyRasters(study);
    study.chapter("display", 0.91);
    studyDisplay(study);
    study.chapter("elements", 0.98);
    studyElements(study);
}

} // namespace

int runStudy(Arguments &words) {
    Job job = readJob(words);
    NewFolder folder(job.out);
    Mesh mesh;
    std::vector<std::string> notes;
    if (job.table41) {
        mesh = columns();
        job.settings.model = "columns";
        job.settings.minutes = 60;
    } else {
        mesh = readObj(job.settings.model, job.options.read, notes);
    }
    stopAt(stop, {SIGINT, SIGTERM});
    Gl gl = openGl();
    Workers workers = allProcessors();
    ProgressBar bar(job.progress);
    std::string name = job.settings.model.substr(job.settings.model.rfind('/') + 1);
    Page page(folder, "A study of radiosity: " + name);
    double began = wallSeconds();
    Study study(job.settings, mesh, gl, workers, &stop, page, bar);
    study.notes.insert(study.notes.begin(), notes.begin(), notes.end());
    if (job.table41) {
        study.chapter("table", 1);
        studyTable(study, true);
    } else {
        runChapters(study);
    }
    writeSummary(study);
    page.finish();
    study.check();
    folder.finish();
    bar.clear();
    std::printf("%s/index.html: %.1f minutes, %zu solutions, %zu measurements left out\n", job.out.c_str(),
                (wallSeconds() - began) / 60, study.measured.size(), study.leftOut.size());
    return 0;
}

} // namespace odraz
