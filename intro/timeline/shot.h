// The film as shots: which scene plays when, seen along which path, and how it fades.
#pragma once

#include "timeline/camera.h"
#include "timeline/track.h"

namespace odraz {

// A shot runs from its row to the next shot's, the last one to the film's end; cuts between them are hard.
// A scene counts its story time from the first of its shots, so that a cut inside it does not break its
// motion.
struct Shot {
    float row;       // film row at which it starts
    int scene;       // index of the scene it shows
    float storyRow;  // film row at which that scene's story starts
    CameraPath path; // rows count from the scene's story start
    float fadeIn;    // rows over which it comes up from black
    float fadeOut;   // rows over which it goes down to black before its end
};

struct ShotList {
    const Shot *shots;
    int count;
    float endRow;
};

struct Moment {
    const Shot *shot;
    double storyRow; // rows since the scene's story began
    float fade;      // 0 black .. 1 full
};

// What is on at a film row. Before the start it is the first shot's first picture, after the end the last's
// last.
Moment momentAt(ShotList list, double row);

} // namespace odraz
