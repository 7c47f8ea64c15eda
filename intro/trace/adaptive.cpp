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

// Finds the shapes that look smaller than a coarse square, or thinner, where they may touch this tile.
void findGrains(Tile &t) {
    TileScratch &s = t.s;
    s.grainCount = 0;
    const View &v = t.view;
    float widest = (float)t.quality.coarse * 1.5f;
    auto place = [&](Vec3 p, float &x, float &y) {
        v.project(p, x, y);
        x -= (float)t.x0, y -= (float)t.y0;
    };
    auto outside = [](float x, float y, float radius) {
        return x + radius < 0 || y + radius < 0 || x - radius > kTile || y - radius > kTile;
    };
    for (int i = 0; i < t.scene.shapeCount && s.grainCount < kGrains; ++i) {
        const Shape &shape = t.scene.shapes[i];
        if (shape.kind == ShapeKind::Plane) continue;
        // Project the ball about it
        const Bounds &b = t.scene.box[i];
        Vec3 middle = (b.lo + b.hi) * 0.5f;
        float r = length(b.hi - b.lo) * (shape.kind == ShapeKind::Sphere ? 0.28868f : 0.5f),
              far = v.ahead(middle);
        if (far <= r * 1.1f) continue;
        float x, y, radius = r / ((far - r) * v.spread);
        place(middle, x, y);
        if (outside(x, y, radius)) continue;
        radius = r / (far * v.spread) * 1.1f;
        if (radius <= widest) {
            s.grains[s.grainCount++] = {x, y, 0, 0, radius};
            continue;
        }
        // A line along its longest side, as thick as the next
        if (shape.kind == ShapeKind::Sphere || shape.kind == ShapeKind::Polygon) continue;
        const float half[3] = {shape.half.x, shape.half.y, shape.half.z};
        int longest = half[0] >= half[1] && half[0] >= half[2] ? 0 : half[1] >= half[2] ? 1 : 2;
        float thick = max(half[(longest + 1) % 3], half[(longest + 2) % 3]);
        Vec3 axis = (longest == 0   ? shape.frame.u
                     : longest == 1 ? shape.frame.v
                                    : shape.frame.w) *
                    half[longest];
        float nearest = min(v.ahead(middle - axis), v.ahead(middle + axis));
        radius = thick / (nearest * v.spread) * 1.1f;
        if (nearest <= r * 0.1f || radius > widest) continue;
        Grain g = {0, 0, 0, 0, radius};
        place(middle - axis, g.x, g.y);
        place(middle + axis, x, y);
        g.alongX = x - g.x, g.alongY = y - g.y;
        s.grains[s.grainCount++] = g;
    }
}

// Whether a small shape may lie in the square between corners that are too far apart to meet it.
bool mayHideGrain(const TileScratch &s, Square q, int size) {
    float half = (float)size * 0.5f, x = (float)q.x + half, y = (float)q.y + half;
    for (int i = 0; i < s.grainCount; ++i) {
        const Grain &g = s.grains[i];
        if ((float)size <= g.radius) continue;
        // The line's point nearest to the square's middle, then the square's nearest to that
        float along = fmadd(x - g.x, g.alongX, (y - g.y) * g.alongY),
              square = fmadd(g.alongX, g.alongX, g.alongY * g.alongY);
        float share = saturate(along / max(square, 1e-12f));
        float dx = max(abs(fmadd(share, g.alongX, g.x) - x) - half, 0.f),
              dy = max(abs(fmadd(share, g.alongY, g.y) - y) - half, 0.f);
        if (fmadd(dx, dx, dy * dy) <= g.radius * g.radius) return true;
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
