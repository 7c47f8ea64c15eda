// trace_once: does one part of the work on one picture once, so that callgrind can count its instructions
// (tools/measure/bench/instructions).
//
// Under callgrind solving the hall takes half an hour. So one run poses the scene, and another, which is
// counted, traces it. A file keeps the memory between them, mapped at the same address. Only the program that
// wrote the file can use it.
#include "tools/common/command_line.h"
#include "tools/measure/bench/peer_scenes.h"
#include "tools/measure/bench/setting.h"
#include "tools/measure/bench/subject.h"
#include "tools/support/machine.h"
#include "trace/picture/development.h"

#include <cstdio>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace odraz::measure {

namespace {

constexpr char kKeptHelp[] = "the file that `pose` wrote";

// The head of the file; the arena follows.
struct KeptScene {
    Intro *intro; // in the arena
    View view;
    IntroSettings settings;
    char scene[64];
};

// Maps a file at a fixed address. `make`: a new file of this size.
KeptScene &map(const std::string &file, size_t bytes, bool make) {
    void *address = (void *)0x200000000000;
    int from = open(file.c_str(), make ? O_RDWR | O_CREAT | O_TRUNC : O_RDONLY, 0666);
    struct stat is;
    if (from < 0 || (make ? ftruncate(from, (off_t)bytes) : fstat(from, &is)) ||
        mmap(address, make ? bytes : (size_t)is.st_size, PROT_READ | PROT_WRITE,
             (make ? MAP_SHARED : MAP_PRIVATE) | MAP_FIXED_NOREPLACE, from, 0) != address)
        throw common::Refused(std::string("cannot ") + (make ? "write " : "read ") + file);
    close(from);
    return *(KeptScene *)address;
}

int pose(common::CommandLine &line) {
    std::string file, scene;
    IntroSettings size = {1280, 720};
    line.about("Poses a scene and keeps it in a file.");
    line.argument("FILE", file, "the file to write");
    line.argument("SCENE", scene, "A, or another scene of tradeoff");
    sizeOption(line, "--size", size, "the picture's size");
    line.parse();
    SubjectName subject = findSubject(scene);
    Workers workers = serialWorkers();
    size.hall = subject.hall;
    size_t bytes = sizeof(KeptScene) + memoryNeeded(size, 1);
    KeptScene &kept = map(file, bytes, true);
    Arena arena = {(unsigned char *)&kept, bytes, sizeof(KeptScene)};
    Gl gl = subject.hall ? openGl() : Gl{};
    if (const char *missing = load(kept.intro, size, arena, workers, kDrawnHemicubes, &gl))
        throw std::runtime_error(missing);
    kept.settings = size;
    std::snprintf(kept.scene, sizeof kept.scene, "%s", scene.c_str());
    kept.view = poseSubject(subject, size, kept.intro->film);
    return 0;
}

// A kept scene, with workers of this process.
struct ReopenedScene {
    KeptScene &kept;
    Workers workers = serialWorkers();
    explicit ReopenedScene(const std::string &file) : kept(map(file, 0, false)) {
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
    ReopenedScene from(fileOf(line, "Poses the kept scene again, as is done for every picture."));
    poseSubject(findSubject(from.kept.scene), from.kept.settings, from.intro().film);
    return 0;
}

int trace(common::CommandLine &line) {
    std::string file, setting;
    line.about("Traces the kept scene.");
    line.argument("FILE", file, kKeptHelp);
    line.argument("SETTING", setting,
                  "a quality, or a quality with changed knobs: draft,threshold=0.02,cutoff=0.015");
    line.parse();
    Quality quality = settingOf(setting);
    ReopenedScene from(file);
    traceFrame(from.intro().tracer, from.workers, *from.intro().film.scene, from.kept.view, quality,
               from.intro().frame);
    return 0;
}

int develop(common::CommandLine &line) {
    ReopenedScene from(
        fileOf(line, "Develops the picture of the kept scene. It was never traced, so it is black."));
    Intro &intro = from.intro();
    spreadGlare(intro.glare, intro.frame, from.workers);
    odraz::develop(intro.curve, intro.frame, from.workers, intro.film.scene->exposure, 0, &intro.glare,
                   kFilmLook);
    return 0;
}

int pov(common::CommandLine &line) {
    std::string scene;
    line.about("Prints a scene in POV-Ray's language.");
    line.argument("SCENE", scene, "A or B");
    line.parse();
    if (scene != "A" && scene != "B") line.refuse("no '" + scene + "' for POV-Ray: use A or B");
    std::fputs(povOf(scene == "B").c_str(), stdout);
    return 0;
}

int run(common::CommandLine &line) {
    line.about("Does one part of the work on a picture once, so that callgrind can count its instructions.");
    return line.run({{"pose", "keep a posed scene in a file", pose},
                     {"again", "pose the kept scene again", again},
                     {"trace", "trace the kept scene", trace},
                     {"develop", "develop its picture", develop},
                     {"pov", "print a scene for POV-Ray", pov}});
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("trace_once", argc, argv, odraz::measure::run); }
