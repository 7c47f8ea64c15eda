// The film's lettering: a small geometric face of straight strokes and arcs, lower case and figures.
#pragma once

#include "trace/picture/overlay.h"

namespace odraz {

enum class Align { Left, Centre, Right };

// Draws a line of text with its baseline at y and its start, middle or end at x (pixels); `size` is the
// height of a figure in pixels, `weight` the stroke's width as a share of it. Unknown characters are left
// out.
void drawText(Frame &frame, const char *text, float x, float y, float size, float weight, float tracking,
              Align align, const Rgb &radiance, float opacity);

} // namespace odraz
