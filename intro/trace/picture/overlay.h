// Draws luminous lines over the traced picture. Text consists of these.
#pragma once

#include "base/vec3.h"
#include "trace/picture/frame.h"

namespace odraz {

// A straight stroke with round ends, in pixels from the top left; a dot if both ends are equal.
struct Stroke {
    float x0, y0, x1, y1;
};

// Lays strokes of the given half width (pixels) over the frame as one figure: overlaps do not add up. Edges
// are anti-aliased; opacity 0 .. 1 mixes `radiance` with the picture below.
void drawStrokes(Frame &frame, const Stroke *strokes, int count, float halfWidth, const Rgb &radiance,
                 float opacity);

} // namespace odraz
