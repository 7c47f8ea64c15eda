// What corners do not tell: balls and thin shapes that may lie between them.
#pragma once

#include "trace/picture/tile.h"

namespace odraz {

// Finds the balls and the thin shapes that the tile may show. Beyond kDiscs and kGrains (tile.h) they are not
// watched for: what is that dense its corners find.
void watch(Tile &t);

// Whether a shape may show in a square without showing at its corners, which all show `shape` (-1: the sky,
// or not the same).
bool mayHideSome(const Tile &t, Square q, int size, int shape);
ODRAZ_INLINE bool mayHide(const Tile &t, Square q, int size, int shape) {
    return (t.s.discs.count | t.s.grainCount) && mayHideSome(t, q, size, shape);
}

} // namespace odraz
