// The time line: a strip along the lower edge with scenes and cuts, bars, events, camera keys, the loop, and
// the current time. Times are in seconds of the film.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/content.h"
#include "maker/panel/steps.h"

namespace odraz::maker {

// The strip's rectangle, and the part of the film that it shows.
struct Strip {
    Rect area = {};
    double end = 1;          // the film's end
    double from = 0, to = 1; // the part shown, within [0, end]

    double timeAt(double x) const; // x in pixels; result within [0, end]
    double xOf(double time) const; // may be outside the rectangle
    // Makes the part shown `factor` times as long. The time at x stays at x.
    void zoom(double x, double factor);
    // Scrolls if `time` is not shown.
    void follow(double time);
};

// Returns the strip for a picture and a film that ends at `end`. Its height is 0 if the picture is small.
Strip stripOf(int width, int height, double end);

// Returns the event at a pixel column of the strip, or null.
const EventInfo *eventNear(const Strip &strip, const Content &content, double x);

// `pointer`: the pixel column of the mouse; below 0: none.
void drawStrip(Canvas &canvas, const Strip &strip, const Content &content, const Loop &loop, double time,
               double pointer);

} // namespace odraz::maker
