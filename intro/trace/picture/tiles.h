// Divides a frame into tiles and works on them in parallel.
#pragma once

#include "base/parallel.h"
#include "trace/picture/tile.h"
#include "trace/picture/tracer.h"

namespace odraz {

// Finds the shapes that primary rays may hit through a square of `size` pixels, whose first one is (x, y) of
// a tile.
void aim(const Tile &tile, int x, int y, int size, Candidates &found);

// Calls f(tile, worker) for every tile of a frame. tile.s.among holds what the tile's primary rays may hit.
template <class F>
void forTiles(Tracer &tracer, Workers &workers, const Scene &scene, const View &view, const Quality &quality,
              Frame &frame, const F &f) {
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i]->sampleCount = 0;
    int across = (frame.width + kTile - 1) / kTile, down = (frame.height + kTile - 1) / kTile;
    parallelFor(workers, across * down, [&](int piece, int worker) {
        // From the bottom up, because tiles at the bottom mostly take longer: the last tiles, during which
        // other workers wait, should be quick
        int last = across * down - 1 - piece, x = last % across * kTile, y = last / across * kTile;
        Tile tile = {
            *tracer.scratch[worker],     scene, view, quality, frame, x, y, min(kTile, frame.width - x),
            min(kTile, frame.height - y)};
        // The border of one pixel allows for rounding errors
        aim(tile, -1, -1, kTile + 2, tile.s.among);
        f(tile, worker);
    });
}

} // namespace odraz
