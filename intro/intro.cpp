#include "intro.h"

#include "inside.h"
#include "trace/picture/enlarge.h"

namespace odraz {

static_assert(kSceneCount <= kMaxScenes && kHeaderRoom <= kPictureMargin);
static_assert(kMostEnlarged == kMostAcross);
static_assert(kSoundRate == kSampleRate && kSoundBlock == kBlock);

bool needsHall(double from, double to) {
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &shot = kFilm.shots[i];
        double start = shot.row / kRowsPerSecond,
               end = (i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow) / kRowsPerSecond;
        if (kScenes[shot.scene].needsHall && from < end && to > start) return true;
    }
    return false;
}

size_t memoryNeeded(const IntroSettings &s, int workers) {
    // Bytes of a pixel: three planes of radiance and a picture; shape and quad where it is traced
    constexpr size_t kPicture = 4, kFrame = 3 * sizeof(float) + kPicture,
                     kTraced = kFrame + sizeof(uint16_t) + sizeof(int32_t), kAlignment = 4096;
    size_t pixels = ((size_t)s.width + 7) * (size_t)s.height, bytes = 0;
    if (s.pairs)
        bytes = kBetweenBytes + 2 * (sizeof(Scene) + pixels * kTraced) +
                (kBetweenBuffers - 1) * pixels * kPicture + 2 * kAlignment;
    bytes += glareBytes(s.width, s.height);
    return bytes + pixels * (kFrame + kPicture) + sizeof(Intro) + sizeof(Scene) +
           (size_t)workers * kTileScratchBytes + kAlignment + (s.hall ? sizeof(Hall) + kRoomBytes : 0);
}

const char *load(Intro *&intro, const IntroSettings &s, Arena &arena, Workers &workers,
                 const HemicubeMethod &method, const Gl *gl, const Progress &progress) {
    intro = arena.allocate<Intro>(1);
    Scene *scene = arena.allocate<Scene>(1);
    Hall *hall = s.hall ? arena.allocate<Hall>(1) : nullptr;
    intro->pairs = s.pairs;
    intro->width = s.width, intro->height = s.height;
    intro->unscaled = arena.allocate<uint8_t>((size_t)s.width * (size_t)s.height * 4 + 2 * kPictureMargin);
    for (Slot &slot : intro->slots) {
        if (!s.pairs) break;
        Traced &t = slot.traced;
        t.scene = arena.allocate<Scene>(1);
        makeFrame(t.frame, arena, s.width, s.height);
        t.frame.shapes = arena.allocate<uint16_t>((size_t)t.frame.stride * (size_t)s.height);
        t.frame.quads = arena.allocate<int32_t>((size_t)t.frame.stride * (size_t)s.height + 8);
    }
    if (s.pairs) makeBetween(intro->between, arena, workers.count);
    for (int k = 1; s.pairs && k < kBetweenBuffers; ++k)
        intro->made[k] =
            arena.allocate<uint8_t>((size_t)s.width * (size_t)s.height * 4 + 2 * kPictureMargin) +
            kPictureMargin;
    if (arena.full || !makeTracer(intro->tracer, arena, workers.count) ||
        !makeFrame(intro->frame, arena, s.width, s.height) ||
        !makeGlare(intro->glare, arena, s.width, s.height))
        return "not enough memory: try a smaller --size";
    intro->made[0] = intro->frame.rgba;
    if (!s.pairs) intro->slots[0].traced = {intro->frame, scene, {}};
    makeToneCurve(intro->curve);
    intro->workers = &workers;
    intro->film = {scene, hall, {s.bytes, s.machine}};
    if (!hall) return nullptr;
    prepareHall(*hall, *scene);
    return solveRoom(*hall, *scene, hallSettings(*hall), {method, gl, arena, workers, progress});
}

double duration() { return kFilm.endRow / kRowsPerSecond; }

double shotStart(double seconds) {
    return momentAt(kFilm, seconds * kRowsPerSecond).shot->row / kRowsPerSecond;
}
int sceneAt(double seconds) { return momentAt(kFilm, seconds * kRowsPerSecond).shot->scene; }

const char *sceneName(int scene) { return kScenes[scene].name; }

Pace paceOf(int scene) { return kScenes[scene].pace.unpacked(); }

CameraKey cameraAt(double seconds) {
    Moment m = momentAt(kFilm, seconds * kRowsPerSecond);
    return pose(m.shot->path, m.storyRow);
}

// Draws text over traced planes, develops them, and scales the picture up into `rgba`.
static Picture finish(Intro &intro, const Posed &now, const View &view, double seconds, float exposure,
                      const Frame &planes, uint8_t *rgba) {
    Frame frame = planes;
    if (now.scene().letter) {
        // Draw on a copy: the traced planes are still needed for in-betweens
        for (int k = 0; k < 3; ++k) frame.plane[k] = intro.frame.plane[k];
        parallelFor(*intro.workers, frame.height, [&](int y, int) {
            ptrdiff_t row = (ptrdiff_t)y * frame.stride;
            for (int k = 0; k < 3 && frame.plane[k] != planes.plane[k]; ++k)
                __builtin_memcpy(frame.plane[k] + row, planes.plane[k] + row, (size_t)frame.stride * 4);
        });
        now.scene().letter(now.input, view, frame);
    }
    bool scaled = frame.width != intro.width || frame.height != intro.height;
    frame.rgba = scaled ? intro.unscaled + kPictureMargin : rgba;
    spreadGlare(intro.glare, frame, *intro.workers);
    // Square the fade, so that it looks even: the eye quickly notices the first light. The noise changes with
    // time, because constant noise would look like a veil. 0.01 is added so that a time that was rounded down
    // gets the same noise
    auto seed = (uint32_t)(seconds * 240 + 0.01);
    develop(intro.curve, frame, *intro.workers, exposure * now.fade * now.fade, seed, &intro.glare,
            kFilmLook);
    if (scaled)
        enlarge(frame.rgba, frame.width, frame.height, rgba, intro.width, intro.height, *intro.workers);
    return {intro.width, intro.height, rgba};
}

Picture picture(Intro &intro, int slot, double seconds, const Quality &quality, const CameraKey *camera,
                TracedSize traced) {
    Slot &s = intro.slots[slot];
    Traced &now = s.traced;
    Film film = intro.film;
    film.scene = now.scene;
    Posed posed = poseAt(film, seconds, camera);
    resize(now.frame, traced.width ? traced.width : intro.width, traced.width ? traced.height : intro.height);
    now.view = posed.view(now.frame.width, now.frame.height);
    s.shot = posed.shot;
    s.seconds = seconds;
    s.quality = quality;
    traceFrame(intro.tracer, *intro.workers, *now.scene, now.view, quality, now.frame);
    if (now.frame.quads) markQuads(now.frame, *intro.workers);
    return finish(intro, posed, now.view, seconds, now.scene->exposure, now.frame, now.frame.rgba);
}

Picture between(Intro &intro, int earlier, int later, double share, int buffer) {
    const Slot *a = &intro.slots[earlier], *b = &intro.slots[later];
    Frame &frame = intro.frame;
    resize(frame, b->traced.frame.width, b->traced.frame.height);
    Traced now = {frame, intro.film.scene, {}};
    double gap = b->seconds - a->seconds, seconds = a->seconds + gap * share;
    Posed posed = poseAt(intro.film, seconds);
    now.view = posed.view(frame.width, frame.height);
    // Next to a cut, use the picture of the same shot twice
    if (a->shot != posed.shot) a = b;
    if (b->shot != posed.shot) b = a;
    const Quality &quality = b->quality;
    if (min(frame.width, frame.height) > 1)
        traceBetween(intro.between, intro.tracer, *intro.workers,
                     {a->traced, b->traced, (float)share, (float)(gap * 60)}, now, quality);
    else
        traceFrame(intro.tracer, *intro.workers, *now.scene, now.view, quality, frame);
    return finish(intro, posed, now.view, seconds, now.scene->exposure, frame, intro.made[buffer]);
}

int64_t samplesTaken(const Intro &intro) { return tracedSamples(intro.tracer); }

size_t soundMemory() { return sizeof(Sound) + 64; }

Sound *loadSound(Arena &arena) {
    Sound *s = arena.allocate<Sound>(1);
    if (s) s->mixer.player = playRow;
    return s;
}

void seekSound(Sound &s, int block) { seekBlock(s.mixer, block); }

void soundBlock(Sound &s, float *stereo) { renderBlock(s.mixer, stereo); }

const char *exceededLimit(const Intro &intro) {
    for (const Slot &slot : intro.slots)
        if (slot.traced.scene && slot.traced.scene->overflow) return slot.traced.scene->overflow;
    return intro.film.scene->overflow;
}

} // namespace odraz
