// The hemicube of scene 4, drawn over the picture. It rises over the visited patch and unfolds next to it,
// showing what that patch sees.
#pragma once

#include "show/hall.h"
#include "trace/picture/frame.h"
#include "trace/rays/view.h"

namespace odraz {

// Draws the hemicube's five faces over its patch. `rise`: 0 draws nothing, 1 the full size of 1.5 m to every
// side. `open`: from 0 to 1 the faces unfold into a cross in the picture's plane. A face shows the patches
// that the hemicube saw, in their present colours, brightened, and `found` faces are filled with light.
void drawHemicube(const Hall &hall, float rise, float open, float found, const View &view, Frame &frame);

} // namespace odraz
