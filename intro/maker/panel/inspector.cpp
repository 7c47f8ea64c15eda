#include "maker/panel/inspector.h"

#include "inside.h"
#include "show/events.h"
#include "tools/common/hash.h"

#include <utility>

namespace odraz::maker {

namespace {

// --- The film's tables ---

int shots(ShotInfo *to, int most) {
    int count = min(kFilm.count, most);
    for (int i = 0; i < count; ++i) {
        const Shot &s = kFilm.shots[i];
        float end = i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow;
        to[i] = {s.row / kRowsPerSecond, end / kRowsPerSecond, s.storyRow / kRowsPerSecond, s.scene, &s.path};
    }
    return count;
}

// Ends with the enumerator's name: "... Id = odraz::kLightIsBorn]"
template <EventId Id> const char *enumerator() { return __PRETTY_FUNCTION__; }

template <int... Ids> void nameOf(int id, EventInfo &to, std::integer_sequence<int, Ids...>) {
    const char *const all[] = {enumerator<(EventId)Ids>()...}, *from = all[id], *begin = from;
    for (const char *c = from; *c; ++c)
        if (*c == ':' || *c == ' ') begin = c + 1;
    for (int i = 0; i + 1 < (int)sizeof to.name && begin[i] && begin[i] != ']' && begin[i] != ';'; ++i)
        to.name[i] = begin[i];
}

int events(EventInfo *to, int most) {
    int count = 0;
    for (const Event &e : kEvents) {
        const Shot *shot = nullptr;
        for (int i = kFilm.count - 1; i >= 0; --i)
            if (kFilm.shots[i].scene == e.scene) shot = &kFilm.shots[i];
        if (!shot || count == most) continue;
        EventInfo &event =
            to[count++] = {(shot->storyRow + e.row) / kRowsPerSecond, (float)e.row, e.heard, {}};
        nameOf(e.id, event, std::make_integer_sequence<int, kEventCount>());
    }
    return count;
}

// --- Materials ---

const Scene &lastScene(const Intro &intro) { return *intro.slots[0].traced.scene; }

int materials(const Intro &intro, MaterialInfo *to) {
    static_assert(kMostMaterials >= kMaxMaterials);
    const Scene &scene = lastScene(intro);
    for (int i = 0; i < scene.materialCount; ++i) {
        const Material &m = scene.materials[i];
        uint64_t hash = common::fnv1a({(const char *)&m, sizeof m});
        to[i] = {hash, 0, m.reflect > 0, m.ior > 0, maxComponent(m.emit) > 0, !m.plain()};
    }
    for (int i = 0; i < scene.shapeCount; ++i) ++to[scene.shapes[i].material].shapes;
    return scene.materialCount;
}

constexpr int kRows = (kMaxMaterials + 3) / 4; // most, for at least four across

size_t swatchMemory(int across, int side) {
    size_t width = (size_t)(across * side), height = (size_t)(kRows * side);
    return sizeof(Scene) + (width + 8) * height * 16 + glareBytes((int)width, (int)height) + (1 << 16);
}

// Balls of radius 0.42 in squares of a metre, seen from so far that all look alike, above a floor and below a
// sky, so that mirrors and glass have something to show.
bool swatches(Intro &intro, Arena &arena, int across, int side, uint8_t *rgba) {
    const Scene &shown = lastScene(intro);
    Scene *scene = arena.take<Scene>(1);
    int rows = (shown.materialCount + across - 1) / across;
    Frame frame;
    if (arena.full || !makeFrame(frame, arena, across * side, max(rows, 1) * side)) return false;
    scene->clear();
    float wide = (float)across, tall = (float)max(rows, 1);
    for (int i = 0; i < shown.materialCount; ++i) {
        Material m = shown.materials[i];
        scene->add(m);
        scene->add(
            sphere({(float)(i % across) + 0.5f - wide * 0.5f, tall * 0.5f - 0.5f - (float)(i / across), 0},
                   0.42f, i));
    }
    scene->add(Light{{-60, 80, 90}, Rgb{1, 1, 1} * 12000.f});
    scene->ambientLow = {0.12f, 0.11f, 0.1f}, scene->ambientHigh = {0.3f, 0.32f, 0.36f};
    scene->sky = plainSky({0.10f, 0.10f, 0.11f}, {0.35f, 0.38f, 0.45f});
    scene->exposure = 1;
    scene->finish();
    constexpr float kAway = 60;
    float degrees = 2 * 57.29578f * tall * 0.5f / kAway; // small enough to take the angle for its tangent
    View view = lookAt({0, 0, kAway}, {0, 0, 0}, 0, degrees, frame.width, frame.height);
    traceFrame(intro.tracer, *intro.workers, *scene, view, kQualities[(int)QualityName::Play], frame);
    frame.rgba = rgba;
    develop(intro.curve, frame, *intro.workers, 1, 0);
    return true;
}

} // namespace

const Inspector &inspector() {
    static constexpr Inspector kInspector = {shots,         events,      materials, swatches,   swatchMemory,
                                             watchPictures, soundMemory, loadSound, soundBlock, drawText};
    return kInspector;
}

} // namespace odraz::maker
