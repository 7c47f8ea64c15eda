#include "intro.h"

#include "inside.h"

namespace odraz {

static_assert(kSceneCount <= kMaxScenes && kHeaderRoom <= kPictureMargin);
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

size_t memoryNeeded(const IntroSettings &s, int workers, bool hall) {
    size_t pixels = ((size_t)s.width + 7) * (size_t)s.height;
    return pixels * 16 + sizeof(Intro) + sizeof(Scene) + (size_t)workers * kTileScratchBytes + 4096 +
           (hall ? sizeof(Hall) + kRoomBytes : 0);
}

const char *load(Intro *&intro, const IntroSettings &s, Arena &arena, Workers &workers, const Gl *gl,
                 const Progress &progress) {
    intro = arena.take<Intro>(1);
    Scene *scene = arena.take<Scene>(1);
    Hall *hall = gl ? arena.take<Hall>(1) : nullptr;
    if (arena.full || !makeTracer(intro->tracer, arena, workers.count) ||
        !makeFrame(intro->frame, arena, s.width, s.height))
        return "not enough memory: try a smaller --size";
    makeCurve(intro->curve);
    intro->workers = &workers;
    intro->film = {scene, hall, {s.bytes, s.machine}};
    if (!gl) return nullptr;
    prepareHall(*hall, *scene);
    return solveRoom(*hall, *scene, hallSettings(*hall), *gl, arena, workers, progress);
}

double duration() { return kFilm.endRow / kRowsPerSecond; }

int sceneAt(double seconds) { return momentAt(kFilm, seconds * kRowsPerSecond).shot->scene; }

const char *sceneName(int scene) { return kScenes[scene].name; }

CameraKey cameraAt(double seconds) {
    Moment m = momentAt(kFilm, seconds * kRowsPerSecond);
    return pose(m.shot->path, m.storyRow);
}

Picture picture(Intro &intro, double seconds, const Quality &quality, const CameraKey *camera) {
    Frame &frame = intro.frame;
    const Scene &scene = *intro.film.scene;
    Posed now = poseAt(intro.film, seconds, camera);
    View view = now.view(frame.width, frame.height);
    traceFrame(intro.tracer, *intro.workers, scene, view, quality, frame);
    if (now.entry->letter) now.entry->letter(now.cue, view, frame);
    // Squared, a fade looks even: the eye is quick to see the first light. The noise moves: what stands still
    // would be seen as a veil
    develop(intro.curve, frame, *intro.workers, scene.exposure * now.fade * now.fade,
            (uint32_t)(seconds * 240));
    return {frame.width, frame.height, frame.rgba};
}

int64_t samplesTaken(const Intro &intro) { return tracedSamples(intro.tracer); }

size_t soundMemory() { return sizeof(Sound) + 64; }

Sound *loadSound(Arena &arena) {
    Sound *s = arena.take<Sound>(1);
    if (s) s->mixer.player = playRow;
    return s;
}

void seekSound(Sound &s, int block) { seekBlock(s.mixer, block); }

void soundBlock(Sound &s, float *stereo) { renderBlock(s.mixer, stereo); }

const char *outgrown(const Intro &intro) { return intro.film.scene->overflow; }

} // namespace odraz
