// Divides a frame into tiles and works on them in parallel.
#pragma once

#include "base/parallel.h"
#include "trace/picture/tile.h"
#include "trace/picture/tracer.h"

namespace odraz {

// Finds the shapes that primary rays may hit through a square of `size` pixels, whose first one is (x, y) of
// a tile.
void aim(const Tile &tile, int x, int y, int size, Candidates &found);

// Calls make(with, tile, worker) for every tile of a frame. tile.s.among holds what the tile's primary rays
// may hit.
void forTiles(Tracer &tracer, Workers &workers, const Scene &scene, const View &view, const Quality &quality,
              Frame &frame, void (*make)(const void *with, Tile &tile, int worker), const void *with);

} // namespace odraz
