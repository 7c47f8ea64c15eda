#include "trace/adaptive.h"

namespace odraz {

static constexpr int kCorners = kTile + 1;
static constexpr int kGrains = 64; // small shapes that a tile can watch for
static constexpr uint16_t kMixed = 0xffff;

// A square of the tile, by its upper left corner.
struct Square {
    uint8_t x, y;
};

// A shape that may slip between the corners, as a disc in the picture.
struct Grain {
    float x, y, radius; // pixels
    uint32_t shape;
};

struct TileScratch {
    TraceScratch trace;
    Sample corners[kCorners * kCorners];
    Rgb shown[kCorners * kCorners]; // intensities of corners as the eye weighs them, texture left out
    uint8_t traced[kCorners * kCorners];
    // Corners wanted next
    uint32_t wanted[kCorners * kCorners];
    int wantedCount;
    Square squares[2][kTile * kTile];
    // The filled tile, pixel by pixel: interpolated light and rest, and whose albedo joins them (kMixed:
    // none)
    float light[3][kTile * kTile + 8], rest[3][kTile * kTile + 8];
    uint16_t owner[kTile * kTile];
    uint16_t pixels[kTile * kTile];    // to super-sample
    Square middles[kTile * kTile / 4]; // squares of 2 pixels with a sample in the middle
    Sample fine[kChunk];
    Grain grains[kGrains];
    int grainCount;
    int64_t sampleCount;
};

namespace {

struct Tile {
    TileScratch &s;
    const Scene &scene;
    const View &view;
    const Quality &quality;
    Frame &frame;
    int x0, y0, width, height; // the part of the frame that it covers
};

// Radiance on a scale on which equal steps look about equally large.
Rgb shown(const Scene &scene, Rgb radiance) {
    auto curve = [](float x) { return sqrt(x / (x + 0.7f)); };
    Rgb v = radiance * scene.exposure;
    return {curve(v.x), curve(v.y), curve(v.z)};
}

float range(const Rgb *const *v, int count) {
    Rgb lo = *v[0], hi = lo;
    for (int i = 1; i < count; ++i) {
        lo = {min(lo.x, v[i]->x), min(lo.y, v[i]->y), min(lo.z, v[i]->z)};
        hi = {max(hi.x, v[i]->x), max(hi.y, v[i]->y), max(hi.z, v[i]->z)};
    }
    return maxComponent(hi - lo);
}

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
            Rgb mean = c.id ? t.scene.mean[t.scene.shapes[(c.id - 1) / 8].material] : Rgb{};
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
        Bounds b = bounds(t.scene, shape);
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

// The first of the four tests of a square's corners, in the thesis's order.
bool onSilhouette(const TileScratch &s, const int *c) {
    for (int i = 1; i < 4; ++i)
        if (s.corners[c[i]].id != s.corners[c[0]].id) return true;
    return false;
}

// All four. Where a mirror or glass shows a texture, the corners of a larger square cannot tell what lies
// between.
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

void cornersOf(Square q, int size, int *c) {
    c[0] = q.y * kCorners + q.x;
    c[1] = c[0] + size;
    c[2] = c[0] + size * kCorners;
    c[3] = c[2] + size;
}

// Interpolates a square over the pixels it covers.
void fill(Tile &t, Square q, int size) {
    TileScratch &s = t.s;
    int c[4];
    cornersOf(q, size, c);
    uint32_t id = s.corners[c[0]].id;
    bool same = true;
    for (int i = 1; i < 4; ++i) same &= s.corners[c[i]].id == id;
    Rgb light[4], rest[4];
    for (int i = 0; i < 4; ++i) {
        const Sample &k = s.corners[c[i]];
        light[i] = same ? k.light : Rgb{};
        rest[i] = same ? k.rest : k.radiance();
    }
    uint16_t owner = same && id ? (uint16_t)((id - 1) / 8) : kMixed;
    // A row of the square is one packet; along it and down the sides everything is linear
    Int8 inside = kLanes < size;
    Float8 u = (toFloat(kLanes) + 0.5f) * (1.f / (float)size);
    auto spread = [&](float *plane, int p, float left, float right) {
        _mm256_maskstore_ps(plane + p, (__m256i)inside, fmadd(u, right - left, broadcast(left)));
    };
    for (int y = 0; y < size; ++y) {
        float v = ((float)y + 0.5f) / (float)size;
        Rgb l0 = lerp(light[0], light[2], v), l1 = lerp(light[1], light[3], v);
        Rgb r0 = lerp(rest[0], rest[2], v), r1 = lerp(rest[1], rest[3], v);
        int p = (q.y + y) * kTile + q.x;
        spread(s.light[0], p, l0.x, l1.x), spread(s.light[1], p, l0.y, l1.y),
            spread(s.light[2], p, l0.z, l1.z);
        spread(s.rest[0], p, r0.x, r1.x), spread(s.rest[1], p, r0.y, r1.y), spread(s.rest[2], p, r0.z, r1.z);
        for (int x = 0; x < size; ++x) s.owner[p + x] = owner;
    }
}

// Fills a square of 2x2 pixels that has a fifth sample in its middle: every pixel lies between that and a
// corner.
void fillByMiddle(Tile &t, Square q) {
    TileScratch &s = t.s;
    int c[4];
    cornersOf(q, 2, c);
    const Sample &middle = s.corners[c[0] + kCorners + 1];
    for (int i = 0; i < 4; ++i) {
        const Sample &corner = s.corners[c[i]];
        int p = (q.y + i / 2) * kTile + q.x + i % 2;
        bool same = corner.id == middle.id && corner.id;
        Rgb light = same ? (corner.light + middle.light) * 0.5f : Rgb{};
        Rgb rest = (same ? corner.rest + middle.rest : corner.radiance() + middle.radiance()) * 0.5f;
        s.light[0][p] = light.x, s.light[1][p] = light.y, s.light[2][p] = light.z;
        s.rest[0][p] = rest.x, s.rest[1][p] = rest.y, s.rest[2][p] = rest.z;
        s.owner[p] = same ? (uint16_t)((corner.id - 1) / 8) : kMixed;
    }
}

// Replaces listed pixels by the mean of side x side samples each; returns how many are left listed because
// their samples still differ by more than the threshold.
int superSample(Tile &t, int count, int side, float threshold) {
    TileScratch &s = t.s;
    int perPixel = side * side, batch = kChunk / perPixel, left = 0;
    float x[kChunk], y[kChunk];
    uint32_t index[kChunk];
    for (int first = 0; first < count; first += batch) {
        int pixels = min(batch, count - first);
        for (int i = 0; i < pixels * perPixel; ++i) {
            int p = s.pixels[first + i / perPixel], k = i % perPixel;
            x[i] = (float)(t.x0 + p % kTile) + ((float)(k % side) + 0.5f) / (float)side;
            y[i] = (float)(t.y0 + p / kTile) + ((float)(k / side) + 0.5f) / (float)side;
            index[i] = (uint32_t)i;
        }
        traceSamples(t.scene, t.view, t.quality, s.trace, pixels * perPixel, x, y, index, s.fine);
        s.sampleCount += pixels * perPixel;
        for (int i = 0; i < pixels; ++i) {
            Rgb sum = {}, seen[16];
            const Rgb *v[16];
            for (int k = 0; k < perPixel; ++k) {
                Rgb c = s.fine[i * perPixel + k].radiance();
                seen[k] = shown(t.scene, c);
                v[k] = &seen[k];
                sum += c;
            }
            int p = s.pixels[first + i];
            Rgb mean = sum * (1.f / (float)perPixel);
            s.light[0][p] = s.light[1][p] = s.light[2][p] = 0;
            s.rest[0][p] = mean.x, s.rest[1][p] = mean.y, s.rest[2][p] = mean.z;
            s.owner[p] = kMixed;
            if (range(v, perPixel) > threshold) s.pixels[left++] = (uint16_t)p;
        }
    }
    return left;
}

// Multiplies every pixel's light by the albedo it sees, and writes the tile into the frame.
void finishTile(Tile &t) {
    TileScratch &s = t.s;
    for (int y = 0; y < t.height; ++y)
        for (int x = 0; x < t.width; x += 8) {
            const int p = y * kTile + x;
            Rgb8 sum = {load(s.rest[0] + p), load(s.rest[1] + p), load(s.rest[2] + p)};
            Rgb8 light = {load(s.light[0] + p), load(s.light[1] + p), load(s.light[2] + p)};
            Float8 px = toFloat(kLanes) + ((float)(t.x0 + x) + 0.5f),
                   py = broadcast((float)(t.y0 + y) + 0.5f);
            int owners[8];
            for (int k = 0; k < 8; ++k) owners[k] = s.owner[p + k];
            Int8 owner = loadInts(owners);
            int left = laneBits((owner != kMixed) & (kLanes < t.width - x));
            while (left) {
                int shape = owner[__builtin_ctz(left)];
                Int8 mine = owner == shape;
                Rgb8 a = albedoSeen(t.scene, t.view, t.scene.shapes[shape], px, py);
                sum = select(mine, sum + a * light, sum);
                left &= ~laneBits(mine);
            }
            size_t out = (size_t)(t.y0 + y) * (size_t)t.frame.stride + (size_t)(t.x0 + x);
            store(t.frame.plane[0] + out, sum.x);
            store(t.frame.plane[1] + out, sum.y);
            store(t.frame.plane[2] + out, sum.z);
        }
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
    TileScratch &s = t.s;
    float x[kChunk], y[kChunk];
    uint32_t index[kChunk];
    int side = t.quality.grid, total = side * side;
    for (int py = 0; py < t.height; ++py)
        for (int px = 0; px < t.width; ++px) {
            Rgb sum = {};
            for (int first = 0; first < total; first += kChunk) {
                int count = min(total - first, kChunk);
                for (int i = 0; i < count; ++i) {
                    x[i] = (float)(t.x0 + px) + ((float)((first + i) % side) + 0.5f) / (float)side;
                    y[i] = (float)(t.y0 + py) + ((float)((first + i) / side) + 0.5f) / (float)side;
                    index[i] = (uint32_t)i;
                }
                traceSamples(t.scene, t.view, t.quality, s.trace, count, x, y, index, s.fine);
                for (int i = 0; i < count; ++i) sum += s.fine[i].radiance();
            }
            s.sampleCount += total;
            size_t out = (size_t)(t.y0 + py) * (size_t)t.frame.stride + (size_t)(t.x0 + px);
            Rgb mean = sum * (1.f / (float)total);
            t.frame.plane[0][out] = mean.x;
            t.frame.plane[1][out] = mean.y;
            t.frame.plane[2][out] = mean.z;
        }
}

} // namespace

const size_t kTileScratchBytes = sizeof(TileScratch) + 64;

bool makeTracer(Tracer &tracer, Arena &arena, int workers) {
    tracer.workers = min(workers, 64);
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
