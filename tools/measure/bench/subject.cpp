#include "tools/measure/bench/subject.h"

#include "tools/common/clock.h"
#include "tools/common/command_line.h"
#include "tools/measure/bench/peer_scenes.h"

#include <cstdlib>

namespace odraz::measure {

namespace {

// A from the side and from above; B from behind and close to its top; the credits from the side and from
// below
constexpr CameraKey kMoreCameras[] = {
    {0, {-5.5f, 1.3f, 5.5f}, {0, 1, 0}, 0, 32},    {0, {2.5f, 5.5f, 4.5f}, {0, 0.9f, -0.2f}, 0, 34},
    {0, {-1.7f, 0.9f, 1.9f}, {0, 0.1f, 0}, 0, 36}, {0, {0.9f, 1.5f, 0.5f}, {0, 0.35f, 0}, 0, 40},
    {0, {2.2f, 1.5f, 3.2f}, {0, 0.55f, 0}, 0, 34}, {0, {-1.2f, 0.35f, 3.1f}, {0, 0.7f, 0}, 0, 38},
};

View viewOf(const CameraKey &c, const IntroSettings &settings) {
    return lookAt(c.eye, c.target, c.roll, c.fov, settings.width, settings.height);
}

} // namespace

const std::vector<SubjectName> &subjectNames() {
    static const std::vector<SubjectName> names = {
        {"A", false, posePeerA, {{0, &kPeerCameraA}, {0, &kMoreCameras[0]}, {0, &kMoreCameras[1]}}},
        {"B",
         false,
         [](Scene &scene) { posePeerB(scene); },
         {{0, &kPeerCameraB}, {0, &kMoreCameras[2]}, {0, &kMoreCameras[3]}}},
        {"field", false, poseField, {{0, &kFieldCamera}}},
        {"point", false, {}, {{14}}},
        {"table", false, {}, {{30}, {21}, {38}}},
        {"flake", false, {}, {{56}, {46}, {62}}},
        {"patches", true, {}, {{86}}},
        {"hall", true, {}, {{108}, {99}, {124}}},
        {"odraz", true, {}, {{142}}},
        {"credits", false, {}, {{159}, {159, &kMoreCameras[4]}, {159, &kMoreCameras[5]}}},
    };
    return names;
}

static SubjectName findSubject(const std::string &name) {
    std::string known;
    for (const SubjectName &n : subjectNames()) {
        if (n.name == name) return n;
        known += " " + n.name;
    }
    throw common::Refused("there is no scene '" + name + "'; there are:" + known);
}

std::pair<SubjectName, size_t> findPicture(const std::string &name) {
    size_t slash = name.find('/'), camera = 0;
    SubjectName subject = findSubject(name.substr(0, slash));
    if (slash != std::string::npos) camera = (size_t)std::atoi(name.c_str() + slash + 1);
    if (camera >= subject.cameras.size())
        throw common::Refused("'" + name + "': cameras are 0 to " +
                              std::to_string(subject.cameras.size() - 1));
    return {subject, camera};
}

View poseSubject(const SubjectName &name, size_t camera, const IntroSettings &settings, const Film &film) {
    const SubjectCamera &by = name.cameras[camera];
    if (!name.pose) return poseAt(film, by.seconds, by.camera).view(settings.width, settings.height);
    film.scene->clear();
    name.pose(*film.scene);
    film.scene->finish();
    return viewOf(*by.camera, settings);
}

Subject::Subject(const SubjectName &what, int width, int height)
    : settings{width, height}, workers(serialWorkers()), name(what), film(settings, workers, what.hall) {}

void Subject::pose(size_t camera) { view = poseSubject(name, camera, settings, film.intro->film); }

double Subject::trace(const Quality &quality) {
    double began = common::processorSeconds();
    traceFrame(film.intro->tracer, workers, *film.intro->film.scene, view, quality, film.intro->frame);
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
    trace(q);
    return picture();
}

} // namespace odraz::measure
