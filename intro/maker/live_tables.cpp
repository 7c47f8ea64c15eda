// In the shared object, value() and pose() are called by way of the functions here (--wrap, in
// CMakeLists.txt).
#include "maker/live_tables.h"

#include "inside.h"

namespace odraz {

float realValue(Track track, float row) __asm__("__real__ZN5odraz5valueENS_5TrackEf");
CameraKey realPose(CameraPath path, float row) __asm__("__real__ZN5odraz4poseENS_10CameraPathEf");
float readValue(Track track, float row) __asm__("__wrap__ZN5odraz5valueENS_5TrackEf");
CameraKey readPose(CameraPath path, float row) __asm__("__wrap__ZN5odraz4poseENS_10CameraPathEf");

namespace {

const Replaced *theReplaced;
int theReplacedCount;

struct Search {
    Table *to;
    int count, most;
    int scene;
    double row; // of the film
} * theSearch;  // null: nothing is looked for

void meet(const void *keys, int count, bool camera, double row) {
    Search *s = theSearch;
    if (!s || !count) return;
    for (int i = 0; i < s->count; ++i)
        if (s->to[i].keys == keys) return;
    if (s->count < s->most) s->to[s->count++] = {keys, count, s->scene, camera, (float)(s->row - row)};
}

const Replaced *replaced(const void *keys) {
    for (int i = 0; i < theReplacedCount; ++i)
        if (theReplaced[i].keys == keys) return theReplaced + i;
    return nullptr;
}

} // namespace

float readValue(Track track, float row) {
    meet(track.keys, track.count, false, row);
    if (const Replaced *r = replaced(track.keys)) track = r->track;
    int i = -1;
    while (i + 1 < track.count && track.keys[i + 1].row <= row) ++i;
    if (i < 0 || i + 1 == track.count || track.keys[i].interpolation < kStep) return realValue(track, row);
    const Key &a = track.keys[i], &b = track.keys[i + 1];
    if (a.interpolation == kStep) return a.value;
    float t = (row - a.row) / (b.row - a.row);
    return a.value + (b.value - a.value) * t * t;
}

CameraKey readPose(CameraPath path, float row) {
    meet(path.keys, path.count, true, row);
    CameraKey result = realPose(path, row);
    if (const Replaced *r = replaced(path.keys))
        for (int c = 0; c < kChannels; ++c) {
            if (!r->channels[c].count) continue;
            CameraKey other = realPose(r->channels[c], row);
            (&result.eye.x)[c] = (&other.eye.x)[c];
        }
    return result;
}

int findTables(Intro &intro, Table *to, int most) {
    static float plane[3][64 * 36];
    Search search = {to, 0, most, 0, 0};
    theSearch = &search;
    Scene &scene = *intro.film.scene;
    for (; search.row < (double)kFilm.endRow; ++search.row) {
        Moment m = momentAt(kFilm, search.row);
        const SceneEntry &entry = kScenes[search.scene = m.shot->scene];
        Cue cue = {m.storyRow, pose(m.shot->path, m.storyRow), intro.film.hall, intro.film.facts};
        scene.clear();
        entry.pose(cue, scene);
        if (!entry.letter) continue;
        Frame frame = {64, 36, 64, {plane[0], plane[1], plane[2]}, nullptr, nullptr};
        const CameraKey &c = cue.camera;
        entry.letter(cue, lookAt(c.eye, c.target, c.roll, c.fov, frame.width, frame.height), frame);
    }
    theSearch = nullptr;
    return search.count;
}

const CameraKey *pathAt(double seconds) { return momentAt(kFilm, seconds * kRowsPerSecond).shot->path.keys; }

// A camera's numbers have keys on the same rows: Tracks::show() makes them so
CameraPath editedPath(CameraPath path) {
    const Replaced *r = replaced(path.keys);
    return r && r->channels[0].count ? r->channels[0] : path;
}

void replaceTables(const Replaced *all, int count) {
    theReplaced = all;
    theReplacedCount = count;
}

} // namespace odraz
