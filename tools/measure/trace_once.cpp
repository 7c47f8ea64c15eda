// trace_once: poses one of the subjects and traces it once, for programs that count
// (tools/measure/instructions).
#include "tools/common/arguments.h"
#include "tools/measure/subject.h"

#include <cstring>

using namespace odraz;

static constexpr char kUsage[] = "usage: trace_once SCENE QUALITY, a scene and a quality of tradeoff trace\n";

static int run(Arguments &words) {
    const char *scene = words.next(), *quality = words.next();
    if (!scene || !quality) throw Refused("a scene and a quality are needed; see trace_once --help");
    for (const Quality &q : kQualities)
        for (const SubjectName &n : subjectNames())
            if (!std::strcmp(scene, n.name) && !std::strcmp(quality, q.name)) {
                Subject(n, 1280, 720).trace(q);
                return 0;
            }
    words.refuse(std::string(scene) + " " + quality);
}

int main(int argc, char **argv) { return runProgram("trace_once", kUsage, argc, argv, run); }
