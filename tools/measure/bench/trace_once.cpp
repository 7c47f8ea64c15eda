// trace_once: traces one subject once, or makes one picture of the film, for programs that count instructions
// (tools/measure/bench/instructions, tools/measure/seen/costs).
//
// Under such a program solving the hall takes half an hour. So one run poses the scene and another traces it.
// Between them a file holds the memory, mapped at the same address; only the program that wrote it can use
// it.
#include "play/governor.h"
#include "tools/common/arguments.h"
#include "tools/common/clock.h"
#include "tools/common/statistics.h"
#include "tools/engine/machine.h"
#include "tools/measure/bench/setting.h"
#include "tools/measure/bench/subject.h"
#include "trace/picture/development.h"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace odraz;

namespace {

constexpr char kUsage[] =
    "usage: trace_once pose FILE SCENE [WIDTH HEIGHT]    keeps a scene in FILE\n"
    "       trace_once film FILE SECONDS LEVEL GAP SHARE [WIDTH HEIGHT]\n"
    "                                                    keeps the film, and two of its pictures, which are\n"
    "                                                    GAP sixtieths of a second apart; the moment is\n"
    "                                                    SHARE, 0 .. 1, of the way from one to the other\n"
    "       trace_once again FILE                        poses it once more, as every picture does\n"
    "       trace_once trace FILE SETTING                traces what FILE keeps\n"
    "       trace_once develop FILE                      develops what was never traced: a black picture\n"
    "       trace_once bare FILE                         ... as without glare\n"
    "       trace_once picture FILE LEVEL                makes the picture of the moment, as it is shown\n"
    "       trace_once between FILE                      makes it from the two that are kept\n"
    "       trace_once time SCENE SETTING THREADS        prints ms of the clock and of all processors: "
    "medians\n"
    "SCENE: of `tradeoff trace`, \"A\" or \"A/2\" for another of its cameras; or \"balls:N\", \"lights:N\"\n"
    "SETTING: a quality, or one with knobs turned: \"draft,threshold=0.02,cutoff=1/64\"\n"
    "LEVEL: a quality as the player blends them: 0 film, 1 play, 2 draft, and all between\n";

constexpr double kSixtieth = 1 / 60.0; // seconds

struct Kept {
    Intro *intro; // stands after this header
    View view;
    IntroSettings settings;
    char scene[64];
    double seconds, share; // of the film, if that is kept
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

// What may run on other threads is counted under this name.
[[gnu::noinline]] void inParallel(Workers &w, int count, int size, void (*body)(const void *, int, int, int),
                                  const void *context) {
    serialWorkers().run(w, count, size, body, context);
}
Workers oneWorker() {
    Workers workers = serialWorkers();
    workers.run = inParallel;
    return workers;
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

void pose(const std::string &file, const std::string &scene, const IntroSettings &settings) {
    auto [name, camera] = findPicture(scene);
    Workers workers = serialWorkers();
    Kept &kept = keep(file, settings, workers, name.hall);
    std::snprintf(kept.scene, sizeof kept.scene, "%s", scene.c_str());
    kept.view = poseSubject(name, camera, settings, kept.intro->film);
}

// The two pictures that the one of a moment is made between.
struct Around {
    double seconds, gap, share; // sixtieths from one to the other; how far it is on the way
};
void keepFilm(const std::string &file, const Around &at, const Quality &setting, IntroSettings settings) {
    settings.pairs = true;
    Workers workers = serialWorkers();
    double from = at.seconds - kSixtieth * at.gap * at.share, to = from + kSixtieth * at.gap;
    Kept &kept = keep(file, settings, workers, needsHall(from, to));
    kept.seconds = at.seconds, kept.share = at.share;
    picture(*kept.intro, 0, from, setting);
    picture(*kept.intro, 1, to, setting);
}

Quality levelAfter(common::Arguments &words) {
    Governor governor;
    governor.coarseness = (float)words.number("LEVEL", 0, Governor::kSteps);
    return governor.quality();
}

// A process can start one set of threads only: each number of threads needs a run of its own.
void time(const std::string &scene, const Quality &setting, int threads) {
    auto [name, camera] = findPicture(scene);
    Subject subject(name, 1280, 720, threads);
    subject.pose(camera);
    std::vector<double> clock, processors;
    for (int round = 0; round < 16; ++round) {
        double began = common::wallSeconds(), before = common::processorSeconds();
        subject.trace(setting);
        processors.push_back((common::processorSeconds() - before) * 1e3);
        clock.push_back((common::wallSeconds() - began) * 1e3);
    }
    std::printf("%.1f %.1f\n", common::median(clock), common::median(processors));
}

IntroSettings sizeAfter(common::Arguments &words) {
    IntroSettings settings = {1280, 720};
    if (const char *width = words.next()) {
        settings.width = std::atoi(width);
        settings.height = words.whole("WIDTH", 16, kMaxHeight);
    }
    if (settings.width < 16 || settings.width > kMaxWidth)
        throw common::Refused("pictures are 16x16 to 7680x4320");
    return settings;
}

int run(common::Arguments &words) {
    auto needed = [&] {
        const char *word = words.next();
        if (!word)
            throw common::Refused("something to do, a file and a name are needed; see trace_once --help");
        return std::string(word);
    };
    std::string what = needed();
    bool known = false;
    for (const char *verb :
         {"pose", "film", "again", "trace", "develop", "bare", "picture", "between", "time"})
        known |= what == verb;
    if (!known) words.refuse(what);
    std::string file = needed();
    if (what == "time") {
        Quality setting = settingOf(needed());
        time(file, setting, words.whole("time", 1, kMaxWorkers));
        return 0;
    }
    if (what == "pose") {
        std::string scene = needed();
        pose(file, scene, sizeAfter(words));
        return 0;
    }
    if (what == "film") {
        Around at = {};
        at.seconds = words.number("SECONDS", 0, duration());
        Quality level = levelAfter(words);
        at.gap = words.number("GAP", 1, 60);
        at.share = words.number("SHARE", 0, 1);
        keepFilm(file, at, level, sizeAfter(words));
        return 0;
    }
    Quality setting = what == "trace"     ? settingOf(needed())
                      : what == "picture" ? levelAfter(words)
                                          : kQualities[0];
    Kept &kept = *(Kept *)map(file, 0, false);
    Intro &intro = *kept.intro;
    Workers workers = oneWorker();
    intro.workers = &workers;
    if (what == "trace")
        traceFrame(intro.tracer, workers, *intro.film.scene, kept.view, setting, intro.frame);
    else if (what == "picture")
        picture(intro, 0, kept.seconds, setting);
    else if (what == "between")
        between(intro, 0, 1, kept.share);
    else if (what == "again") {
        auto [name, camera] = findPicture(kept.scene);
        poseSubject(name, camera, kept.settings, intro.film);
    } else {
        spreadGlare(intro.glare, intro.frame, workers);
        bool bare = what == "bare";
        develop(intro.curve, intro.frame, workers, intro.film.scene->exposure, 0,
                bare ? nullptr : &intro.glare, bare ? kPlainLook : kFilmLook);
    }
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("trace_once", kUsage, argc, argv, run); }
