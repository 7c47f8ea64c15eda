#include "intro.h"

namespace odraz {

bool needsHall(double from, double to) {
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &shot = kFilm.shots[i];
        double start = shot.row / kRowsPerSecond,
               end = (i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow) / kRowsPerSecond;
        if (kScenes[shot.scene].needsHall && from < end && to > start) return true;
    }
    return false;
}

size_t memoryNeeded(int width, int height, int workers, bool hall) {
    size_t pixels = ((size_t)width + 7) * (size_t)height;
    return pixels * 16 + sizeof(Scene) + (size_t)workers * kTileScratchBytes + 4096 +
           (hall ? sizeof(Hall) + hallBytes() : 0);
}

const char *load(Intro &intro, Arena &arena, Workers &workers, int width, int height, const Facts &facts,
                 const Gl *gl, const Progress &progress) {
    intro.workers = &workers;
    intro.facts = facts;
    intro.scene = arena.take<Scene>(1);
    if (!intro.scene || !makeTracer(intro.tracer, arena, workers.count) ||
        !makeFrame(intro.picture, arena, width, height))
        return "not enough memory: try a smaller --size";
    if (!gl) return nullptr;
    intro.hall = arena.take<Hall>(1);
    return intro.hall ? loadHall(*intro.hall, *intro.scene, *gl, arena, workers, progress)
                      : "not enough memory";
}

double duration() { return kFilm.endRow / kRowsPerSecond; }

int sceneAt(double seconds) { return momentAt(kFilm, seconds * kRowsPerSecond).shot->scene; }

CameraKey cameraAt(double seconds) {
    Moment m = momentAt(kFilm, seconds * kRowsPerSecond);
    return pose(m.shot->path, m.storyRow);
}

const Frame &frame(Intro &intro, double seconds, const Quality &quality, const CameraKey *camera) {
    // Pose
    Moment m = momentAt(kFilm, seconds * kRowsPerSecond);
    const SceneEntry &entry = kScenes[m.shot->scene];
    Scene &scene = *intro.scene;
    CameraKey c = camera ? *camera : pose(m.shot->path, m.storyRow);
    scene.clear();
    scene.eye = c.eye;
    entry.pose(m.storyRow, intro.hall, scene);
    scene.finish();

    // Trace, letter, develop
    Frame &picture = intro.picture;
    View view = lookAt(c.eye, c.target, c.roll, c.fov, picture.width, picture.height);
    traceFrame(intro.tracer, *intro.workers, scene, view, quality, picture);
    if (entry.letter) entry.letter(m.storyRow, intro.hall, intro.facts, view, picture);
    // Squared, a fade looks even: the eye is quick to see the first light
    develop(picture, *intro.workers, scene.exposure * m.fade * m.fade);
    return picture;
}

} // namespace odraz
