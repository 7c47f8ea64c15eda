#include "tools/measure/bench/subject.h"

#include "tools/common/clock.h"
#include "tools/common/command_line.h"
#include "tools/measure/bench/peer_scenes.h"

namespace odraz::measure {

const std::vector<SubjectName> &subjectNames() {
    static const std::vector<SubjectName> names = {
        {"A", false, posePeerA, &kPeerCameraA},
        {"B", false, [](Scene &scene) { posePeerB(scene); }, &kPeerCameraB},
        {"field", false, poseField, &kFieldCamera},
        {.name = "point", .hall = false, .seconds = 10},
        {.name = "table", .hall = false, .seconds = 22},
        {.name = "flake", .hall = false, .seconds = 44},
        {.name = "patches", .hall = true, .seconds = 74},
        {.name = "hall", .hall = true, .seconds = 88},
        {.name = "odraz", .hall = true, .seconds = 118},
        {.name = "credits", .hall = false, .seconds = 159},
    };
    return names;
}

SubjectName findSubject(const std::string &name) {
    return common::named(subjectNames(), name, "scene", [](const SubjectName &n) { return n.name; });
}

View poseSubject(const SubjectName &subject, const IntroSettings &settings, const Film &film) {
    if (!subject.pose) return poseAt(film, subject.seconds, nullptr).view(settings.width, settings.height);
    film.scene->clear();
    subject.pose(*film.scene);
    film.scene->finish();
    if (film.scene->overflow) throw std::runtime_error(film.scene->overflow);
    const CameraKey &c = *subject.camera;
    return lookAt(c.eye, c.target, c.roll, c.fov, settings.width, settings.height);
}

Subject::Subject(const SubjectName &what, int width, int height)
    : settings{width, height}, workers(allProcessors()), film(settings, workers, what.hall),
      view(poseSubject(what, settings, film.intro->film)) {}

double Subject::trace(const Quality &quality) {
    Workers one = serialWorkers();
    double began = common::processorSeconds();
    traceFrame(film.intro->tracer, one, *film.intro->film.scene, view, quality, film.intro->frame);
    return (common::processorSeconds() - began) * 1e3;
}

double Subject::samplesPerPixel() const {
    return (double)tracedSamples(film.intro->tracer) / (film.intro->frame.width * film.intro->frame.height);
}

std::vector<uint8_t> Subject::picture() const {
    const Frame &f = film.intro->frame;
    std::vector<uint8_t> bytes((size_t)f.width * (size_t)f.height * 3);
    for (int y = 0; y < f.height; ++y)
        for (int x = 0; x < f.width; ++x)
            for (int c = 0; c < 3; ++c) {
                Float8 v = broadcast(f.plane[c][(size_t)y * (size_t)f.stride + (size_t)x]);
                float shown = encodeSrgb(clamp(v * film.intro->film.scene->exposure, 0.f, 1.f))[0];
                bytes[((size_t)y * (size_t)f.width + (size_t)x) * 3 + (size_t)c] =
                    (uint8_t)(shown * 255 + 0.5f);
            }
    return bytes;
}

std::vector<uint8_t> Subject::reference() {
    Quality q = kQualities[(int)QualityName::Reference];
    q.grid = 16;
    traceFrame(film.intro->tracer, workers, *film.intro->film.scene, view, q, film.intro->frame);
    return picture();
}

} // namespace odraz::measure
