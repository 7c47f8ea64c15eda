// The half-cube of scene 4, drawn over the picture: over the patch that is visited, and unfolded beside it
// into what that patch sees.
#pragma once

#include "show/hall.h"
#include "trace/picture/frame.h"
#include "trace/rays/view.h"

namespace odraz {

// Draws its edges over its patch, 1.5 m to every side once `rise` is 1; and its five faces as a cross, which
// grows from the patch to its place and folds its sides out while `open` goes from 0 to 1. A face shows what
// the hemicube saw, in the colours that patches have now. If `rise` or `open` is 0, its part is not drawn.
void drawHalfCube(const Hall &hall, float rise, float open, const View &view, Frame &frame);

} // namespace odraz
