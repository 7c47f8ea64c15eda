// The film's content, as the engine sees it: a list of shots, and for every scene how it is posed and
// lettered.
//
// Story rows count from the start of a scene's first shot (8 a second, 16 a bar). Posing is a pure function
// of the row: no scene remembers anything.
#pragma once

#include "show/hall.h"
#include "timeline/shot.h"
#include "trace/picture/frame.h"
#include "trace/scene/scene.h"
#include "trace/rays/view.h"

namespace odraz {

// What the credits tell of this copy and this machine; null or 0 where it must not enter the picture (dumps).
struct Facts {
    int64_t bytes;       // size of the executable
    const char *machine; // the processor's name
};

struct SceneEntry {
    const char *name;
    // Fills a cleared scene; the hall may be null where it is not needed
    void (*pose)(double row, Hall *hall, Scene &scene);
    // Draws over the linear picture; or null
    void (*letter)(double row, const Hall *hall, const Facts &facts, const View &view, Frame &frame);
    bool needsHall;
};

enum SceneId { kPoint, kTable, kFlake, kPatches, kHall, kOdraz, kCredits, kSceneCount };
extern const SceneEntry kScenes[kSceneCount];
extern const ShotList kFilm;

// Each in a file of its own.
void posePoint(double row, Hall *, Scene &scene);
void letterPoint(double row, const Hall *, const Facts &facts, const View &, Frame &frame);
void poseTable(double row, Hall *, Scene &scene);
void poseFlake(double row, Hall *, Scene &scene);
void posePatches(double row, Hall *hall, Scene &scene);
void letterPatches(double row, const Hall *hall, const Facts &, const View &view, Frame &frame);
void poseDay(double row, Hall *hall, Scene &scene);
void poseOdraz(double row, Hall *hall, Scene &scene);
void poseCredits(double row, Hall *, Scene &scene);
void letterCredits(double row, const Hall *, const Facts &facts, const View &, Frame &frame);

} // namespace odraz
