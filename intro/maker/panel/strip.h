// The time line: a strip along the lower edge with scenes and cuts, bars, events, keys of cameras, the loop,
// and the current time. Times are seconds of the film.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/content.h"
#include "maker/panel/steps.h"

#include <vector>

namespace odraz::maker {

// The film's time of a key of a shot's camera.
inline double timeOf(const ShotInfo &shot, const CameraKey &key) {
    return shot.story + key.row / kRowsPerSecond;
}

// The strip's place, and the part of the film that it shows.
struct Strip {
    Rect area = {};
    double end = 1;          // of the film
    double from = 0, to = 1; // shown, within [0, end]

    double timeAt(double x) const; // of a pixel; within [0, end]
    double xOf(double time) const; // may lie outside of the area
    // Shows a part `factor` times as long. The time at x stays at x.
    void zoom(double x, double factor);
    // Moves on if `time` is not shown.
    void follow(double time);
};

// The strip for a picture's size and a film that ends at `end`. Its height is 0 if the picture is too small
// for it.
Strip stripOf(int width, int height, double end);

// The event at a pixel of the strip, or null.
const EventInfo *eventNear(const Strip &strip, const Content &content, double x);

// `pointer`: the pixel column that the mouse is over, or below 0.
void drawStrip(Canvas &canvas, const Strip &strip, const Content &content, const Loop &loop, double time,
               double pointer);

} // namespace odraz::maker
