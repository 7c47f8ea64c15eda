#include "tools/common/folders.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/generate/generate.h"
#include "tools/radiosity/solve/solve_options.h"
#include "tools/radiosity/study/study.h"

#include <span>

namespace odraz::radiosity {

namespace {

struct StudyJob {
    StudySettings settings;
    std::string out;
    bool table41 = false;
    SolveOptions options;
};

void readStudyJob(common::CommandLine &line, StudyJob &job) {
    line.about("Measures the methods on a model: sizes and rasters, passes, gathering and shooting, "
               "display.\n"
               "Writes a folder with a page, index.html, and tables as CSV. Ctrl-C ends it with the\n"
               "chapters that are done.");
    line.argument("MODEL", job.settings.model, "a Wavefront OBJ or glTF", false);
    line.option("-o", "FOLDER", job.out, "the new folder");
    line.flag("--quick", job.settings.quick,
              "only the smaller sizes and rasters, and fewer patches, shots and rays");
    line.flag("--table41", job.table41,
              "the thesis's Table 4.1 instead: the hall of columns, up to 546,048 patches; about five "
              "minutes of two processors");
    job.options.addTo(line, SolveOptions::For::kStudy);
    line.parse();
    // Collect the options for the commands on the page
    for (const auto &[option, value] : line.givenOf(SolveOptions::groups()))
        job.settings.options += " " + option + (value.empty() ? "" : " " + common::shellWord(value));
    if (job.table41 != job.settings.model.empty())
        throw common::Refused(job.table41 ? "--table41 takes no model: it generates the hall of columns"
                                          : "name a model: radiosity study MODEL.obj -o FOLDER");
    if (job.out.empty()) throw common::Refused("name a folder for the page with -o FOLDER");
    job.options.finish(line);
    job.settings.solve = job.options.settings;
    job.settings.upIsZ = job.options.upIsZ;
}

Mesh columns(const ReadSettings &settings, std::vector<std::string> &notes) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "columns.mtl", generateMtl());
    common::writeWhole(folder / "columns.obj", "mtllib columns.mtl\n" + generateObj("columns", 0));
    return readModel(folder / "columns.obj", settings, notes);
}

struct Chapter {
    const char *name;
    int tasks, quickTasks; // number of solutions and gathers
    void (*write)(Study &study);
};
constexpr Chapter kChapters[] = {{"methods", 1, 1, studyMethods},
                                 {"table", 9, 4, [](Study &s) { studyTable(s, false); }},
                                 {"rasters", 25, 17, studyRasters},
                                 {"display", 2, 2, studyDisplay}};
constexpr Chapter kTable41[] = {{"table", 9, 4, [](Study &s) { studyTable(s, true); }}};

// Runs the chapters. Returns false if the user interrupted; throws Interrupted if no chapter is done by then.
bool writeChapters(Study &study, std::span<const Chapter> chapters) {
    bool anyDone = false;
    for (const Chapter &c : chapters) {
        try {
            study.page.keep();
            study.chapter(c.name);
            c.write(study);
            anyDone = true;
        } catch (const Interrupted &) {
            study.page.drop();
            if (!anyDone && study.page.empty()) throw;
            for (const Chapter *left = &c; left < chapters.data() + chapters.size(); ++left)
                study.leftOut.push_back(std::string(left->name) + ": interrupted");
            return false;
        }
    }
    return true;
}

} // namespace

int runStudy(common::CommandLine &line) {
    StudyJob job;
    readStudyJob(line, job);
    common::NewFolder folder(job.out);
    Mesh mesh;
    std::vector<std::string> notes;
    if (job.table41) {
        mesh = columns(job.options.read, notes);
        job.settings.model = "columns.obj"; // as `generate columns` writes it
    } else {
        mesh = readModel(job.settings.model, job.options.read, notes);
        job.options.addLights(mesh, job.settings.solve.surroundings, notes);
    }
    std::string name = job.settings.model.substr(job.settings.model.rfind('/') + 1);
    Page page(folder, "A study of radiosity: " + name);
    std::span<const Chapter> chapters = kChapters;
    if (job.table41) chapters = kTable41;
    for (const Chapter &c : chapters) job.settings.tasks += job.settings.quick ? c.quickTasks : c.tasks;
    Study study(job.settings, mesh, page, job.options.progress);
    study.notes.insert(study.notes.begin(), notes.begin(), notes.end());
    bool complete = writeChapters(study, chapters);
    writeSummary(study);
    page.finish();
    folder.finish();
    if (!complete)
        throw std::runtime_error("interrupted: " + job.out + "/index.html has what was measured until then");
    study.print(job.out + "/index.html: " + common::counted(study.measured.size(), "solution"));
    return 0;
}

} // namespace odraz::radiosity
