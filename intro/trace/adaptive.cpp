#include "trace/adaptive.h"

#include "trace/tile.h"

namespace odraz {

namespace {

void want(TileScratch &s, int x, int y) {
    int i = y * kCorners + x;
    if (s.traced[i]) return;
    s.traced[i] = 1;
    s.wanted[s.wantedCount++] = (uint32_t)i;
}

void traceWanted(Tile &t) {
    TileScratch &s = t.s;
    float x[kChunk], y[kChunk];
    for (int first = 0; first < s.wantedCount; first += kChunk) {
        int count = min(s.wantedCount - first, kChunk);
        for (int i = 0; i < count; ++i) {
            x[i] = (float)(t.x0 + (int)(s.wanted[first + i] % kCorners));
            y[i] = (float)(t.y0 + (int)(s.wanted[first + i] / kCorners));
        }
        traceSamples(t.scene, t.view, t.quality, s.trace, count, x, y, s.wanted + first, s.corners);
        for (int i = 0; i < count; ++i) {
            uint32_t k = s.wanted[first + i];
            const Sample &c = s.corners[k];
            Rgb mean = c.id ? t.scene.mean[t.scene.shapes[c.shape()].material] : Rgb{};
            s.shown[k] = shown(t.scene, mean * c.light + c.rest);
        }
    }
    s.sampleCount += s.wantedCount;
    s.wantedCount = 0;
}

// Finds the shapes that look smaller than a coarse square, where they may touch this tile.
void findGrains(Tile &t) {
    TileScratch &s = t.s;
    s.grainCount = 0;
    const View &v = t.view;
    for (int i = 0; i < t.scene.shapeCount && s.grainCount < kGrains; ++i) {
        const Shape &shape = t.scene.shapes[i];
        if (shape.kind == ShapeKind::Plane) continue;
        // Project the ball about it
        const Bounds &b = t.scene.box[i];
        Vec3 to = (b.lo + b.hi) * 0.5f - v.eye;
        float r = length(b.hi - b.lo) * (shape.kind == ShapeKind::Sphere ? 0.28868f : 0.5f);
        float ahead = dot(to, v.forward);
        if (ahead <= 2 * r) continue;
        float radius = r / (ahead * v.spread) * 1.1f;
        if (radius > (float)t.quality.coarse * 1.5f) continue;
        auto along = [&](Vec3 axis) { return dot(to, axis) / (ahead * dot(axis, axis)) + 0.5f; };
        float x = along(v.right) * v.width - (float)t.x0, y = along(v.down) * v.height - (float)t.y0;
        if (x + radius < 0 || y + radius < 0 || x - radius > kTile || y - radius > kTile) continue;
        s.grains[s.grainCount++] = {x, y, radius, (uint32_t)i};
    }
}

// Whether a small shape may lie in the square between corners that are too far apart to meet it.
bool mayHideGrain(const TileScratch &s, Square q, int size) {
    for (int i = 0; i < s.grainCount; ++i) {
        const Grain &g = s.grains[i];
        float x = clamp(g.x, (float)q.x, (float)(q.x + size)) - g.x,
              y = clamp(g.y, (float)q.y, (float)(q.y + size)) - g.y;
        if ((float)size > g.radius && x * x + y * y <= g.radius * g.radius) return true;
    }
    return false;
}

// The four tests of a square's corners, in the thesis's order. Where a mirror or glass shows a texture, the
// corners of a larger square cannot tell what lies between.
bool differ(const TileScratch &s, const int *c, int size, float threshold) {
    if (onSilhouette(s, c)) return true;
    for (int i = 0; i < 4 && size > 2; ++i)
        if (s.corners[c[i]].textured) return true;
    const Sample &a = s.corners[c[0]];
    for (int i = 1; i < 4; ++i)
        if (s.corners[c[i]].lights != a.lights) return true;
    for (int i = 1; i < 4; ++i)
        if (s.corners[c[i]].secondary != a.secondary) return true;
    const Rgb *v[4] = {&s.shown[c[0]], &s.shown[c[1]], &s.shown[c[2]], &s.shown[c[3]]};
    return range(v, 4) > threshold;
}

void traceAdaptive(Tile &t) {
    TileScratch &s = t.s;
    const Quality &q = t.quality;
    for (uint8_t &traced : s.traced) traced = 0;
    s.wantedCount = 0;
    findGrains(t);

    // Begin with coarse squares
    int count = 0;
    Square *squares = s.squares[0], *next = s.squares[1];
    for (int y = 0; y < t.height; y += q.coarse)
        for (int x = 0; x < t.width; x += q.coarse) squares[count++] = {(uint8_t)x, (uint8_t)y};
    for (int i = 0; i < count; ++i) {
        int x = squares[i].x, y = squares[i].y;
        want(s, x, y), want(s, x + q.coarse, y), want(s, x, y + q.coarse),
            want(s, x + q.coarse, y + q.coarse);
    }
    traceWanted(t);

    // Split what differs, level by level; fill the rest
    int rough = 0, middles = 0;
    for (int size = q.coarse; count; size /= 2) {
        int splits = 0, half = size / 2;
        for (int i = 0; i < count; ++i) {
            Square a = squares[i];
            int c[4];
            cornersOf(a, size, c);
            bool split =
                size > q.fine && (size > q.inner ? differ(s, c, size, q.threshold) : onSilhouette(s, c));
            split |= size > q.fine && mayHideGrain(s, a, size);
            if (!split && size == 2 && q.middle && differ(s, c, size, q.threshold)) {
                want(s, a.x + 1, a.y + 1);
                s.middles[middles++] = a;
                continue;
            }
            if (!split) {
                fill(t, a, size);
                if (size > 1 || q.levels == 0) continue;
                Rgb seen[4];
                for (int k = 0; k < 4; ++k) seen[k] = shown(t.scene, s.corners[c[k]].radiance());
                const Rgb *v[4] = {&seen[0], &seen[1], &seen[2], &seen[3]};
                bool textureOnly = s.owner[a.y * kTile + a.x] != kMixed && !differ(s, c, size, q.edge);
                if ((!textureOnly && range(v, 4) > q.edge) || mayHideGrain(s, a, size))
                    s.pixels[rough++] = (uint16_t)(a.y * kTile + a.x);
                continue;
            }
            for (int k = 0; k < 4; ++k) {
                Square child = {(uint8_t)(a.x + half * (k & 1)), (uint8_t)(a.y + half * (k >> 1))};
                if (child.x < t.width && child.y < t.height) next[splits++] = child;
            }
            want(s, a.x + half, a.y), want(s, a.x, a.y + half), want(s, a.x + half, a.y + half);
            want(s, a.x + size, a.y + half), want(s, a.x + half, a.y + size);
        }
        traceWanted(t);
        Square *done = squares;
        squares = next;
        next = done;
        count = splits;
    }

    for (int i = 0; i < middles; ++i) fillByMiddle(t, s.middles[i]);

    // Super-sample pixels whose corners differ, and once more those whose samples still do
    for (int level = 1; level <= q.levels && rough; ++level)
        rough = superSample(t, rough, 1 << level, q.edge * (float)(1 << level));
    finishTile(t);
}

void traceGrid(Tile &t) {
    int count = 0;
    for (int y = 0; y < t.height; ++y)
        for (int x = 0; x < t.width; ++x) t.s.pixels[count++] = (uint16_t)(y * kTile + x);
    superSample(t, count, t.quality.grid, kInfinity);
    finishTile(t);
}

} // namespace

const size_t kTileScratchBytes = sizeof(TileScratch) + 64;

bool makeTracer(Tracer &tracer, Arena &arena, int workers) {
    if (workers > kMaxWorkers) return false;
    tracer.workers = workers;
    for (int i = 0; i < tracer.workers; ++i)
        if (!(tracer.scratch[i] = arena.take<TileScratch>(1))) return false;
    return true;
}

void traceFrame(Tracer &tracer, Workers &workers, const Scene &scene, const View &view,
                const Quality &quality, Frame &frame) {
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i]->sampleCount = 0;
    int across = (frame.width + kTile - 1) / kTile, down = (frame.height + kTile - 1) / kTile;
    parallelFor(workers, across * down, [&](int piece, int worker) {
        int x = piece % across * kTile, y = piece / across * kTile;
        Tile tile = {
            *tracer.scratch[worker],     scene, view, quality, frame, x, y, min(kTile, frame.width - x),
            min(kTile, frame.height - y)};
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
