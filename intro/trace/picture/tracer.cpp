#include "trace/picture/tracer.h"

#include "trace/picture/adaptive.h"
#include "trace/picture/tiles.h"

namespace odraz {

// Finds what the tile's primary rays may meet; a pixel around it keeps roundings out.
void aimTile(Tile &t) {
    float x0 = (float)t.x0 - 1, y0 = (float)t.y0 - 1, x1 = (float)(t.x0 + kTile + 1),
          y1 = (float)(t.y0 + kTile + 1);
    const View &v = t.view;
    gather(t.scene,
           beamThrough(v.eye,
                       {v.direction(x0, y0), v.direction(x1, y0), v.direction(x1, y1), v.direction(x0, y1)}),
           t.s.among);
}

namespace {

// The same number of samples in every pixel: as many rows as a chunk holds, once for each place in a pixel.
void traceGrid(Tile &t) {
    TileScratch &s = t.s;
    int side = t.quality.grid, perPixel = side * side, wide = (t.width + 7) & ~7, rows = kChunk / wide;
    for (uint32_t i = 0; i < kChunk; ++i) s.index[i] = i;
    for (int y = t.y0, end = t.y0 + t.height; y < end; y += rows) {
        int count = min(rows, end - y) * wide;
        for (int k = 0; k < perPixel; ++k) {
            float dx = ((float)(k % side) + 0.5f) / (float)side,
                  dy = ((float)(k / side) + 0.5f) / (float)side;
            for (int i = 0; i < count; i += 8) {
                store(s.x + i, toFloat(kLanes + (t.x0 + i % wide)) + dx);
                store(s.y + i, broadcast((float)(y + i / wide) + dy));
            }
            traceSamples(t.scene, t.view, t.quality, s.trace, s.among, 1 / (float)side, count, s.x, s.y,
                         s.index, s.fine);
            for (int i = 0; i < count; i += 8) {
                Rgb8 sum = eightColours(s.fine + i);
                size_t at = (size_t)(y + i / wide) * (size_t)t.frame.stride + (size_t)(t.x0 + i % wide);
                for (int c = 0; c < 3; ++c) {
                    float *out = t.frame.plane[c] + at;
                    Float8 v = c == 0 ? sum.x : c == 1 ? sum.y : sum.z;
                    if (k > 0) v += load(out);
                    store(out, k + 1 < perPixel ? v : v / broadcast((float)perPixel));
                }
            }
        }
    }
    s.sampleCount += t.width * t.height * perPixel;
}

} // namespace

const size_t kTileScratchBytes = sizeof(TileScratch) + 64;

bool makeTracer(Tracer &tracer, Arena &arena, int workers) {
    if (workers > kMaxWorkers) return false;
    tracer.workers = workers;
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i] = arena.take<TileScratch>(1);
    return !arena.full;
}

void traceFrame(Tracer &tracer, Workers &workers, const Scene &scene, const View &view,
                const Quality &quality, Frame &frame) {
    forTiles(tracer, workers, scene, view, quality, frame, [&](Tile &tile, int) {
        if (quality.grid > 0)
            traceGrid(tile);
        else
            traceAdaptive(tile);
    });
}

int64_t tracedSamples(const Tracer &tracer) {
    int64_t samples = 0;
    for (int i = 0; i < tracer.workers; ++i) samples += tracer.scratch[i]->sampleCount;
    return samples;
}

} // namespace odraz
