// Finds shapes that the corners may miss: balls and thin shapes between them.
#pragma once

#include "trace/picture/tile.h"

namespace odraz {

// Finds the balls and the thin shapes that the tile may show, up to kDiscs and kThinShapes (tile.h). If there
// are more, they are so close together that corners hit them.
void findBallsAndThinShapes(Tile &t);

// Whether a square may show a shape that no corner shows. All corners show `shape`; -1: the sky, or several.
bool mayHideShape(const Tile &t, Square q, int size, int shape);
ODRAZ_INLINE bool mayHide(const Tile &t, Square q, int size, int shape) {
    return (t.s.discs.count | t.s.thin.count) && mayHideShape(t, q, size, shape);
}

} // namespace odraz
