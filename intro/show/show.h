// The film's content as the engine uses it: a list of shots, and the functions that pose each scene and draw
// its text.
//
// Story rows count from the start of a scene's first shot (8 a second, 16 a bar). Posing is pure: no state.
#pragma once

#include "show/events.h"
#include "show/hall.h"
#include "show/look.h"
#include "timeline/pace.h"
#include "timeline/shot.h"
#include "trace/rays/view.h"

namespace odraz {

// Facts that the credits show about this copy and this machine; null or 0 if the picture must not depend on
// them (dumps).
struct Facts {
    int64_t bytes;       // size of the executable
    const char *machine; // the processor's name
};

// The input of posing and lettering.
struct SceneInput {
    float row;        // in the scene's story
    CameraKey camera; // scripted or flown
    Hall *hall;       // null if no scene needs it
    Facts facts;
};

struct SceneEntry {
    const char *name;
    void (*pose)(const SceneInput &in, Scene &scene); // fills a cleared scene
    // Draws over the linear picture; may be null
    void (*letter)(const SceneInput &in, const View &view, Frame &frame) = nullptr;
    SceneId id;
    bool needsHall = false;
    PackedPace pace = Pace{};
};

extern const SceneEntry kScenes[kSceneCount];
extern const ShotList kFilm;

// The data for making pictures: the scene, which is posed for each picture, and data that all pictures share.
struct Film {
    Scene *scene;
    Hall *hall; // null if no scene needs it
    Facts facts;
};

// The result of poseAt(): the shot, the input with the camera, and the fade.
struct Posed {
    const Shot *shot;
    SceneInput input;
    float fade; // 0 black .. 1 full

    const SceneEntry &scene() const { return kScenes[shot->scene]; }
    View view(int width, int height) const {
        const CameraKey &c = input.camera;
        return lookAt(c.eye, c.target, c.roll, c.fov, width, height);
    }
};

// Poses the film's scene at a time, ready to be traced. `camera` replaces the scripted one.
Posed poseAt(const Film &film, double seconds, const CameraKey *camera = nullptr);

} // namespace odraz
