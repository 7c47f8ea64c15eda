// The film as a list of shots: which scene plays when, along which camera path, and how it fades.
#pragma once

#include "timeline/camera.h"
#include "timeline/track.h"

namespace odraz {

// A shot runs from its row to the row of the next shot, the last one to the end of the film. Cuts between
// shots are hard. A scene counts its story time from the first of its shots, so a cut within a scene does not
// break the motion.
struct Shot {
    float row;       // film row at which it starts
    int scene;       // index of the scene it shows
    float storyRow;  // film row at which that scene's story starts
    CameraPath path; // its rows count from the start of the scene's story
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
    float storyRow; // rows since the scene's story began
    float fade;     // 0 black .. 1 full
};

// What plays at a film row. Before the start this is the first picture of the first shot, after the end the
// last picture of the last shot.
Moment momentAt(ShotList list, double at);

} // namespace odraz
