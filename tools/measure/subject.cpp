#include "tools/measure/subject.h"

#include "tools/common/clock.h"
#include "tools/common/machine.h"
#include "tools/measure/peer_scenes.h"
#include "trace/picture/development.h"

#include <cstring>
#include <stdexcept>

namespace odraz {

const std::vector<SubjectName> &subjectNames() {
    static const std::vector<SubjectName> names = {
        {"A", -1, false},     {"B", -1, false},        {"field", -1, false},  {"point", 14, false},
        {"table", 30, false}, {"flake", 64, false},    {"patches", 93, true}, {"hall", 108, true},
        {"odraz", 144, true}, {"credits", 159, false},
    };
    return names;
}

View poseSubject(const SubjectName &name, const IntroSettings &settings, const Film &film) {
    if (name.seconds >= 0) return poseAt(film, name.seconds).view(settings.width, settings.height);
    Scene &scene = *film.scene;
    scene.clear();
    bool a = !std::strcmp(name.name, "A"), b = !std::strcmp(name.name, "B");
    a ? posePeerA(scene) : b ? posePeerB(scene) : poseField(scene);
    scene.finish();
    CameraKey camera = a ? kPeerCameraA : b ? kPeerCameraB : kFieldCamera;
    return lookAt(camera.eye, camera.target, camera.roll, camera.fov, settings.width, settings.height);
}

Subject::Subject(const SubjectName &name, int width, int height)
    : settings{width, height}, memory(memoryNeeded(settings, 1, name.hall)), workers(serialWorkers()) {
    Gl gl = name.hall ? openGl() : Gl{};
    if (const char *missing = load(intro, settings, memory.arena, workers, name.hall ? &gl : nullptr))
        throw std::runtime_error(std::string(name.name) + ": " + missing);

    theView = poseSubject(name, settings, intro->film);
}

double Subject::trace(const Quality &quality) {
    double began = threadSeconds();
    traceFrame(intro->tracer, workers, scene(), theView, quality, intro->frame);
    return (threadSeconds() - began) * 1e3;
}

double Subject::samplesPerPixel() const {
    return (double)tracedSamples(intro->tracer) / (intro->frame.width * intro->frame.height);
}

std::vector<uint8_t> Subject::picture() const {
    const Frame &f = intro->frame;
    std::vector<uint8_t> bytes((size_t)f.width * (size_t)f.height * 3);
    for (int y = 0; y < f.height; ++y)
        for (int x = 0; x < f.width; ++x)
            for (int c = 0; c < 3; ++c) {
                Float8 v = broadcast(f.plane[c][(size_t)y * (size_t)f.stride + (size_t)x]);
                float shown = encodeSrgb(clamp(v * intro->film.scene->exposure, 0.f, 1.f))[0];
                bytes[((size_t)y * (size_t)f.width + (size_t)x) * 3 + (size_t)c] =
                    (uint8_t)(shown * 255 + 0.5f);
            }
    return bytes;
}

const std::vector<uint8_t> &Subject::reference() {
    if (truth.empty()) {
        Quality q = kQualities[(int)QualityName::Reference];
        q.grid = 16;
        trace(q);
        truth = picture();
    }
    return truth;
}

} // namespace odraz
