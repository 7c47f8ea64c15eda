#include "trace/picture/tracer.h"

#include "trace/picture/adaptive.h"
#include "trace/picture/tiles.h"

namespace odraz {

// Whether to ignore a rectangle because the eye is behind it, or sees it so nearly edge-on that it is thinner
// than the distance between samples. The few samples that hit it would show a dashed line.
static bool edgeOn(const Tile &t, const Shape &s) {
    if (!s.isRectangle()) return false;
    Vec3 e = s.frame * (t.view.eye - s.centre);
    if (e.y <= 0) return true;
    float x = abs(e.x), z = abs(e.z), dx = max(x - s.half.x, 0.f), dz = max(z - s.half.z, 0.f),
          square = fmadd(dx, dx, fmadd(dz, dz, e.y * e.y)), across = sqrt(fmadd(x, x, z * z));
    // The rectangle's length in the direction of the eye
    float chord = min(s.half.x * across / max(x, 1e-9f), s.half.z * across / max(z, 1e-9f)) * 2;
    return e.y * e.y < square * 0.01f &&
           chord * e.y < square * t.view.spread * 0.05f * (float)t.quality.smallest;
}

void findCandidates(const Tile &t, int x, int y, int size, Candidates &found) {
    float x0 = (float)(t.x0 + x), y0 = (float)(t.y0 + y), x1 = x0 + (float)size, y1 = y0 + (float)size;
    const View &v = t.view;
    findCandidates(t.scene,
                   beamThrough(v.eye, {v.direction(x0, y0), v.direction(x1, y0), v.direction(x1, y1),
                                       v.direction(x0, y1)}),
                   found);
    int kept = 0;
    for (int i = 0; i < found.count; ++i) {
        if (edgeOn(t, t.scene.shapes[found.shape[i]])) continue;
        found.near[kept] = found.near[i];
        found.shape[kept] = found.shape[i];
        found.ball[kept++] = found.ball[i];
    }
    if (found.count > 0) found.count = kept;
}

namespace {

// Takes a grid of samples in every pixel: traces the rows of a chunk once for each position in the grid.
void traceGrid(Tile &t) {
    TileScratch &s = t.s;
    int side = t.quality.grid, perPixel = side * side, wide = (t.width + 7) & ~7, rows = kChunk / wide;
    float white = whiteOf(t.scene);
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
            traceSamples(t.scene, t.view, t.quality, s.trace,
                         {s.candidates, 1 / (float)side, count, s.x, s.y, s.index}, s.inside);
            for (int i = 0; i < count; i += 8) {
                Rgb8 seen = eightColours(s.inside + i);
                size_t at = (size_t)(y + i / wide) * (size_t)t.frame.stride + (size_t)(t.x0 + i % wide);
                for (int c = 0; c < 3; ++c) {
                    float *out = t.frame.plane[c] + at, *darkest = s.rest[c] + i;
                    Float8 v = c == 0 ? seen.x : c == 1 ? seen.y : seen.z, sum = min(v, broadcast(white));
                    if (k > 0) v = min(v, load(darkest)), sum += load(out);
                    store(darkest, v);
                    store(out, k + 1 < perPixel ? sum : max(sum / broadcast((float)perPixel), v));
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
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i] = arena.allocate<TileScratch>(1);
    return !arena.full;
}

void forTiles(Tracer &tracer, Workers &workers, const Scene &scene, const View &view, const Quality &quality,
              Frame &frame, TileWork work) {
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i]->sampleCount = 0;
    int across = (frame.width + kTile - 1) / kTile, down = (frame.height + kTile - 1) / kTile;
    parallelFor(workers, across * down, [&](int piece, int worker) {
        // Start with the bottom tiles, which mostly take longer, so that no worker waits long at the end
        int last = across * down - 1 - piece, x = last % across * kTile, y = last / across * kTile;
        Tile tile = {
            *tracer.scratch[worker],     scene, view, quality, frame, x, y, min(kTile, frame.width - x),
            min(kTile, frame.height - y)};
        // The border of one pixel allows for rounding errors
        findCandidates(tile, -1, -1, kTile + 2, tile.s.candidates);
        work.make(work.with, tile, worker);
    });
}

void traceFrame(Tracer &tracer, Workers &workers, const Scene &scene, const View &view,
                const Quality &quality, Frame &frame) {
    auto make = [](const void *, Tile &tile, int) {
        if (tile.quality.grid > 0)
            traceGrid(tile);
        else
            traceAdaptive(tile);
    };
    forTiles(tracer, workers, scene, view, quality, frame, {make, nullptr});
}

int64_t tracedSamples(const Tracer &tracer) {
    int64_t samples = 0;
    for (int i = 0; i < tracer.workers; ++i) samples += tracer.scratch[i]->sampleCount;
    return samples;
}

} // namespace odraz
