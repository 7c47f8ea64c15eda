// trace_once: poses one of the subjects and traces it once, for programs that count
// (tools/measure/instructions).
#include "tools/measure/subject.h"

#include <cstdio>
#include <cstring>
#include <stdexcept>

using namespace odraz;

int main(int argc, char **argv) {
    for (int i = 0; argc == 3 && i < (int)QualityName::Count; ++i)
        for (const SubjectName &n : subjectNames()) {
            if (std::strcmp(argv[1], n.name) || std::strcmp(argv[2], kQualityNames[i])) continue;
            try {
                Subject(n, 1280, 720).trace(kQualities[i]);
                return 0;
            } catch (const std::runtime_error &e) {
                std::fprintf(stderr, "trace_once: %s\n", e.what());
                return 1;
            }
        }
    std::fprintf(stderr, "usage: trace_once SCENE QUALITY; scenes are those of tradeoff trace\n");
    return 2;
}
