// The half-cube of scene 4, drawn over the picture: it rises over the patch that is visited, and unfolds
// beside it into what that patch sees.
#pragma once

#include "show/hall.h"
#include "trace/picture/frame.h"
#include "trace/rays/view.h"

namespace odraz {

// Draws its five faces over its patch, 1.5 m to every side once `rise` is 1; if that is 0, nothing. While
// `open` goes from 0 to 1 they fold out and become a cross in the picture's plane. A face shows what the
// hemicube saw, patch by patch, in the colours that patches have now, brightened.
void drawHalfCube(const Hall &hall, float rise, float open, const View &view, Frame &frame);

} // namespace odraz
