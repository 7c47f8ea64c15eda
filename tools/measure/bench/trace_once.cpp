// trace_once: traces one subject once, for programs that count instructions
// (tools/measure/bench/instructions).
//
// Under such a program solving the hall takes half an hour. So one run poses the scene and another traces it.
// Between them a file holds the memory, mapped at the same address; only the program that wrote it can use
// it.
#include "tools/common/command_line.h"
#include "tools/engine/machine.h"
#include "tools/measure/bench/peer_scenes.h"
#include "tools/measure/bench/setting.h"
#include "tools/measure/bench/subject.h"
#include "trace/picture/development.h"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace odraz::measure {

namespace {

constexpr char kSceneHelp[] = "A, or another scene of tradeoff trace",
               kSettingHelp[] = "a quality, or one with knobs turned: draft,threshold=0.02,cutoff=1/64",
               kKeptHelp[] = "what `pose` kept";

struct Kept {
    Intro *intro; // behind this header
    View view;
    IntroSettings settings;
    char scene[64];
};

size_t bytesFor(const IntroSettings &settings) { return sizeof(Kept) + memoryNeeded(settings, 1, true); }

void *map(const std::string &file, size_t bytes, bool make) {
    void *place = (void *)0x200000000000;
    int from = open(file.c_str(), make ? O_RDWR | O_CREAT | O_TRUNC : O_RDONLY, 0666);
    struct stat is;
    if (from < 0 || (make ? ftruncate(from, (off_t)bytes) : fstat(from, &is)) ||
        mmap(place, make ? bytes : (size_t)is.st_size, PROT_READ | PROT_WRITE,
             (make ? MAP_SHARED : MAP_PRIVATE) | MAP_FIXED_NOREPLACE, from, 0) != place)
        throw common::Refused(file + " cannot be " + (make ? "written" : "read"));
    close(from);
    return place;
}

Kept &keep(const std::string &file, const IntroSettings &settings, Workers &workers, bool hall) {
    size_t bytes = bytesFor(settings);
    Kept &kept = *(Kept *)map(file, bytes, true);
    Arena arena = {(unsigned char *)&kept, bytes, sizeof(Kept)};
    Gl gl = hall ? openGl() : Gl{};
    kept.settings = settings;
    if (const char *missing = load(kept.intro, settings, arena, workers, hall ? &gl : nullptr))
        throw std::runtime_error(missing);
    return kept;
}

int pose(common::CommandLine &line) {
    std::string file, scene;
    IntroSettings size = {1280, 720};
    line.about("Poses a scene and keeps it in a file.");
    line.argument("FILE", file, "the file to write");
    line.argument("SCENE", scene, kSceneHelp);
    sizeOption(line, "--size", size, "the picture's size");
    line.parse();
    SubjectName subject = findSubject(scene);
    Workers workers = serialWorkers();
    Kept &kept = keep(file, size, workers, subject.hall);
    std::snprintf(kept.scene, sizeof kept.scene, "%s", scene.c_str());
    kept.view = poseSubject(subject, size, kept.intro->film);
    return 0;
}

// What a file keeps, on one thread.
struct Reopened {
    Kept &kept;
    Workers workers = serialWorkers();
    explicit Reopened(const std::string &file) : kept(*(Kept *)map(file, 0, false)) {
        kept.intro->workers = &workers;
    }
    Intro &intro() { return *kept.intro; }
};
std::string fileOf(common::CommandLine &line, const char *about) {
    std::string file;
    line.about(about);
    line.argument("FILE", file, kKeptHelp);
    line.parse();
    return file;
}

int again(common::CommandLine &line) {
    Reopened from(fileOf(line, "Poses the scene once more, as every picture does."));
    poseSubject(findSubject(from.kept.scene), from.kept.settings, from.intro().film);
    return 0;
}

int trace(common::CommandLine &line) {
    std::string file, setting;
    line.about("Traces the scene.");
    line.argument("FILE", file, kKeptHelp);
    line.argument("SETTING", setting, kSettingHelp);
    line.parse();
    Quality quality = settingOf(setting);
    Reopened from(file);
    traceFrame(from.intro().tracer, from.workers, *from.intro().film.scene, from.kept.view, quality,
               from.intro().frame);
    return 0;
}

int develop(common::CommandLine &line) {
    Reopened from(fileOf(line, "Develops the scene's picture, which was never traced: it is black."));
    Intro &intro = from.intro();
    spreadGlare(intro.glare, intro.frame, from.workers);
    odraz::develop(intro.curve, intro.frame, from.workers, intro.film.scene->exposure, 0, &intro.glare,
                   kFilmLook);
    return 0;
}

int pov(common::CommandLine &line) {
    std::string scene;
    line.about("Prints a scene as POV-Ray reads it.");
    line.argument("SCENE", scene, "A or B");
    line.parse();
    if (scene != "A" && scene != "B") line.refuse("POV-Ray's scenes are A and B, not '" + scene + "'");
    std::fputs(povOf(scene == "B").c_str(), stdout);
    return 0;
}

int run(common::CommandLine &line) {
    line.about("Does one part of a picture's work once, for programs that count instructions.");
    return line.run({{"pose", "keep a posed scene in a file", pose},
                     {"again", "pose the kept scene once more", again},
                     {"trace", "trace the kept scene", trace},
                     {"develop", "develop its picture", develop},
                     {"pov", "print a scene for POV-Ray", pov}});
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("trace_once", argc, argv, odraz::measure::run); }
