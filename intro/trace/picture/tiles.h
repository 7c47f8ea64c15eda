// A frame as tiles, for who goes through them in parallel.
#pragma once

#include "base/parallel.h"
#include "trace/picture/tile.h"
#include "trace/picture/tracer.h"

namespace odraz {

// Finds what primary rays through a square of a tile's pixels, from its pixel (x, y) on, may meet.
void aim(const Tile &tile, int x, int y, int size, Candidates &found);

// f(tile, worker) for every tile of a frame, aimed: it knows what its rays may meet.
template <class F>
void forTiles(Tracer &tracer, Workers &workers, const Scene &scene, const View &view, const Quality &quality,
              Frame &frame, const F &f) {
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i]->sampleCount = 0;
    int across = (frame.width + kTile - 1) / kTile, down = (frame.height + kTile - 1) / kTile;
    parallelFor(workers, across * down, [&](int piece, int worker) {
        int x = piece % across * kTile, y = piece / across * kTile;
        Tile tile = {
            *tracer.scratch[worker],     scene, view, quality, frame, x, y, min(kTile, frame.width - x),
            min(kTile, frame.height - y)};
        // What its primary rays may meet; a pixel around it keeps roundings out
        aim(tile, -1, -1, kTile + 2, tile.s.among);
        f(tile, worker);
    });
}

} // namespace odraz
