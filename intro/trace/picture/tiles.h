// Divides a frame into tiles and works on them in parallel.
#pragma once

#include "base/parallel.h"
#include "trace/picture/tile.h"
#include "trace/picture/tracer.h"

namespace odraz {

// Finds the shapes that primary rays may hit in a square of the tile, `size` pixels wide, from (x, y) on.
void findCandidates(const Tile &tile, int x, int y, int size, Candidates &found);

// A function that makes a tile, and its first argument.
struct TileWork {
    void (*make)(const void *with, Tile &tile, int worker);
    const void *with;
};
// Calls make(with, tile, worker) for every tile of a frame. tile.s.candidates are those of the whole tile.
void forTiles(Tracer &tracer, Workers &workers, const Scene &scene, const View &view, const Quality &quality,
              Frame &frame, TileWork work);

} // namespace odraz
