// The film as a list of shots: which scene plays when, along which camera path, and how it fades.
#pragma once

#include "timeline/camera.h"
#include "timeline/track.h"

#include <stdint.h>

namespace odraz {

// A shot lasts from its row to the row of the next shot, or to the end of the film. Cuts between shots are
// hard. A scene's story time counts from its first shot, so a cut within a scene does not interrupt motion.
struct Shot {
    int16_t row;      // film row at which it starts
    uint8_t scene;    // index of the scene that it shows
    int16_t storyRow; // film row at which the scene's story starts
    CameraPath path;  // its rows count from storyRow
    uint8_t fadeIn;   // rows over which it fades in from black
    uint8_t fadeOut;  // rows over which it fades to black before its end
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

// Returns the shot at a film row. Before the film this is the start of the first shot, after it the end of
// the last shot.
Moment momentAt(ShotList list, double at);

} // namespace odraz
