// A frame as tiles, for who goes through them in parallel.
#pragma once

#include "base/parallel.h"
#include "trace/picture/tile.h"
#include "trace/picture/tracer.h"

namespace odraz {

// Finds what the tile's primary rays may meet.
void aimTile(Tile &tile);

// f(tile, worker) for every tile of a frame, aimed.
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
        aimTile(tile);
        f(tile, worker);
    });
}

} // namespace odraz
