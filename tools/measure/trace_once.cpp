// trace_once: traces one subject once, for programs that count (tools/measure/instructions).
//
// Under these, solving the hall takes half an hour. So one run poses, another traces, and in between a file
// keeps the memory as it is, mapped at the same place: good for the very program that wrote it.
#include "tools/common/arguments.h"
#include "tools/common/machine.h"
#include "tools/measure/subject.h"

#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

using namespace odraz;

namespace {

constexpr char kUsage[] =
    "usage: trace_once pose FILE SCENE       keeps a scene of `tradeoff trace` in FILE\n"
    "       trace_once trace FILE QUALITY    traces what FILE keeps\n";
constexpr IntroSettings kSettings = {1280, 720};

struct Kept {
    Intro *intro; // behind it
    View view;
};

Kept &map(const char *file, bool pose) {
    size_t bytes = sizeof(Kept) + memoryNeeded(kSettings, 1, true);
    void *place = (void *)0x200000000000;
    int from = open(file, pose ? O_RDWR | O_CREAT | O_TRUNC : O_RDONLY, 0666);
    if (from < 0 || (pose && ftruncate(from, (off_t)bytes)) ||
        mmap(place, bytes, PROT_READ | PROT_WRITE, (pose ? MAP_SHARED : MAP_PRIVATE) | MAP_FIXED_NOREPLACE,
             from, 0) != place)
        throw Refused(std::string(file) + " cannot be " + (pose ? "written" : "read"));
    close(from);
    return *(Kept *)place;
}

void pose(Kept &kept, const SubjectName &name) {
    Arena arena = {(unsigned char *)&kept, sizeof(Kept) + memoryNeeded(kSettings, 1, true), sizeof(Kept)};
    Workers workers = serialWorkers();
    Gl gl = name.hall ? openGl() : Gl{};
    if (const char *missing = load(kept.intro, kSettings, arena, workers, name.hall ? &gl : nullptr))
        throw std::runtime_error(missing);
    kept.view = poseSubject(name, kSettings, kept.intro->film);
}

void trace(Kept &kept, const Quality &quality) {
    Intro &intro = *kept.intro;
    Workers workers = serialWorkers();
    traceFrame(intro.tracer, workers, *intro.film.scene, kept.view, quality, intro.frame);
}

int run(Arguments &words) {
    const char *what = words.next(), *file = words.next(), *which = words.next();
    if (!which) throw Refused("something to do, a file and a name are needed; see trace_once --help");
    if (!std::strcmp(what, "pose")) {
        for (const SubjectName &n : subjectNames())
            if (!std::strcmp(which, n.name)) {
                pose(map(file, true), n);
                return 0;
            }
    } else if (!std::strcmp(what, "trace")) {
        for (const Quality &q : kQualities)
            if (!std::strcmp(which, q.name)) {
                trace(map(file, false), q);
                return 0;
            }
    } else
        words.refuse(what);
    words.refuse(which);
}

} // namespace

int main(int argc, char **argv) { return runProgram("trace_once", kUsage, argc, argv, run); }
