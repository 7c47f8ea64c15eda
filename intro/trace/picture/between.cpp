#include "trace/picture/between.h"

#include "trace/picture/adaptive.h"
#include "trace/picture/carry.h"
#include "trace/picture/tiles.h"

namespace odraz {

// How much of two pictures may be reused where they show a shape.
struct Trust {
    float tolerance; // difference up to which their colours agree
    int alone;       // whether one picture counts where the other one does not show the shape: -1 yes, 0 no
    float brightest; // eight pixels count only if none of them is brighter, in multiples of white
};

namespace {

constexpr int kRow = kTile + 16, kRows = kTile + 2; // a tile with a border of one pixel; rows are padded
constexpr int kRowStep = 8;                         // rows at this distance are always traced; a power of two
constexpr int kBlock = 8; // side of the blocks of pixels that are carried by their corners
// Tolerated difference at a gap of 2/60 s (it is proportional to the gap), and its limit in flat mirrors.
constexpr float kTolerance = 0.06f, kMirrorTolerance = 0.09f;
// Distances by which reflections move across a ball between the pictures, in radians as seen from the eye.
// Beyond kTorn, parts of the ball that only one picture shows do not count. Beyond kGhosts the tolerance
// shrinks: equal colours may be background that is seen on both sides of a moving object. What glass shows
// moves up to twenty times as fast: kTornInGlass is kTorn for glass of any shape.
constexpr float kTorn = 0.0028f, kTornInGlass = 0.00014f, kGhosts = 0.0055f;
// Reflections of lamps slide over a flat mirror: both pictures may show one where the in-between has none. So
// nothing above kBright is reused if the eye moves by more than kSlides times its distance from the mirror.
constexpr float kBright = 0.25f, kSlides = 0.2f;
constexpr float kBlinding = 2.5f;      // in multiples of white; see join()
constexpr int kSamples = 3;            // number of samples in a pixel that is traced again
constexpr float kSampleStep = 0.33f;   // distance between these, across and down, in pixels
constexpr float kFetchedShare = 0.5f;  // share of the fetched radiance in a pixel that is traced again
constexpr int kInside = kTile * kTile; // a flag in a pixel's index: one shape fills it
constexpr int kMaxRetraced = kTile * kTile / 8; // pixels; a tile with more is traced as a whole

} // namespace

struct BetweenScratch {
    // The tile with a border of one pixel: shape and distance (unit: the length of direction()) of each pixel
    int32_t shape[kRows * kRow];
    float along[kRows * kRow];
    uint16_t retraced[kMaxRetraced + kBlock * kBlock]; // numbers of pixels
};

namespace {

// The two pictures, and the maps of every shape to them.
struct Sources {
    const Frame &before, &after;
    Carry *const (&carry)[2];
    const Trust *trust;
    float share; // weight of the later picture
    float exposure;
    BetweenScratch *scratch; // one for every worker
};

[[gnu::cold]] void findTrust(const Traced &before, const Traced &after, const Traced &now, float gap,
                             Carry *const (&carry)[2], Trust *trust) {
    const Scene &scene = *now.scene;
    // Next to a cut, `before` and `after` are the same picture: measure the motion from it to now
    const bool one = before.scene == after.scene;
    for (int i = 0; i <= scene.shapeCount; ++i) {
        const Shape &a = scene.shapes[i];
        const Material &m = scene.materials[a.material];
        trust[i] = {kTolerance * gap * 0.5f, -1, kInfinity};
        if (i == scene.shapeCount || carry[0][i].shape == kNone || carry[1][i].shape == kNone) continue;
        const bool glass = m.ior > 0;
        // Limit flat mirrors: the reflections that slide over them are not tracked
        if (m.reflect > 0 && !a.isBall()) {
            trust[i].tolerance = min(trust[i].tolerance, kMirrorTolerance);
            if (length(after.view.eye - before.view.eye) >
                kSlides * abs(dot(now.view.eye - a.centre, a.frame.v)))
                trust[i].brightest = kBright, trust[i].alone = 0;
        }
        if (!glass && (m.reflect <= 0 || !a.isBall())) continue;
        Vec3 u = before.scene->shapes[carry[0][i].shape].centre - before.view.eye,
             v = one ? a.centre - now.view.eye
                     : after.scene->shapes[carry[1][i].shape].centre - after.view.eye;
        float perLength = 1 / length(u);
        // Limit glass and mirror balls. The reflecting normal turns by half the angle between the eyes
        float moves = length(u * perLength - v * (1 / length(v))) * 0.5f * a.half.x * perLength;
        if (!glass) trust[i].tolerance *= min(kGhosts / max(moves, 1e-6f), 1.f);
        if (moves <= (glass ? kTornInGlass : kTorn)) continue;
        trust[i].alone = 0;
        if (one) trust[i].tolerance = -1;
    }
}

// Traces pixels: with one sample if one shape fills them, else with kSamples in different rows and columns.
void tracePixels(Tile &t, const uint16_t *pixels, int count) {
    TileScratch &s = t.s;
    const __m128 white = _mm_set1_ps(whiteOf(t.scene));
    for (int n; count > 0; count -= n, pixels += n) {
        n = min(count, kChunk / kSamples);
        int samples = 0;
        for (int i = 0; i < n; ++i)
            for (int k = -1; k < 2; ++k) {
                bool inside = pixels[i] >= kInside;
                int across = k, down = k == 1 ? -1 : k + 1;
                float step = inside ? 0 : kSampleStep;
                s.x[samples] = (float)(t.x0 + pixels[i] % kTile) + 0.5f + (float)across * step;
                s.y[samples] = (float)(t.y0 + pixels[i] / kTile % kTile) + 0.5f + (float)down * step;
                s.index[samples] = (uint32_t)samples;
                ++samples;
                if (inside) break;
            }
        traceSamples(t.scene, t.view, t.quality, s.trace, {s.candidates, 0.5f, samples, s.x, s.y, s.index},
                     s.inside);
        s.sampleCount += samples;
        for (int i = 0, next = 0; i < n; ++i) {
            int perPixel = pixels[i] >= kInside ? 1 : kSamples;
            ptrdiff_t at = (ptrdiff_t)s.y[next] * t.frame.stride + (ptrdiff_t)s.x[next];
            __m128 sum = {}, least = s.inside[next], most = least;
            for (int k = 0; k < perPixel; ++k) {
                __m128 v = s.inside[next++];
                sum += _mm_min_ps(v, white);
                least = _mm_min_ps(least, v), most = _mm_max_ps(most, v);
            }
            float *const *plane = t.frame.plane;
            __m128 fetched = {plane[0][at], plane[1][at], plane[2][at], 0};
            // Mix in the fetched radiance, which reduces the noise of these few samples. Limit it to three
            // times the brightest sample, so that nothing remains of a bright object that the samples miss
            sum = _mm_max_ps(sum * (1 / (float)perPixel), least) * (1 - kFetchedShare) +
                  _mm_max_ps(_mm_min_ps(fetched, most * 3), least) * kFetchedShare;
            for (int c = 0; c < 3; ++c) plane[c][at] = sum[c];
        }
    }
}

// Finds the shapes that the pixels in and around a tile show. A row between two rows of the same shapes is
// not traced but interpolated: on planes 1 / along is linear. If this misses something small, the traced
// pictures show it there, so they do not match and the pixel is traced.
ODRAZ_INLINE void findShapes(const Tile &t, BetweenScratch &b) {
    const int sky = t.scene.shapeCount;
    const View &v = t.view;
    for (int step = kRowStep; step; step >>= 1) {
        const int between = step % kRowStep; // 0 in the first round, whose rows are all traced
        for (int y = between; y < kRows; y += step + between)
            for (int x = 0; x < kTile + 2; x += 8) {
                int32_t *shape = b.shape + y * kRow + x;
                float *along = b.along + y * kRow + x;
                int next = y + between < kRows ? between * kRow : 0;
                Int8 same = loadInts(shape - next);
                if (next && !any(same != loadInts(shape + next))) {
                    store(shape, same);
                    Float8 above = load(along - next), below = load(along + next);
                    store(along, above * below * 2.f / (above + below));
                    continue;
                }
                Vec3x8 d = v.direction(toFloat(kLanes) + ((float)(t.x0 + x) - 0.5f),
                                       broadcast((float)(t.y0 + y) - 0.5f));
                Float8 perLength = 1.f / length(d);
                Hit8 hit = intersect(t.scene, t.s.candidates, v.eye, d * perLength, kLanes >= 0);
                Int8 none = hit.shape < 0;
                store(shape, select(none, broadcast(sky), hit.shape));
                store(along, select(none, 1.f, hit.t * perLength));
            }
    }
}

Float8 brightest(const Rgb8 &v) { return max(v.x, max(v.y, v.z)); }

// The mix of both pictures' colours, and where they differ by no more than the tolerance.
struct Blend {
    Rgb8 radiance;
    Int8 agrees;
};
ODRAZ_INLINE Blend blend(const Sources &from, const Trust &trust, const Fetched &before,
                         const Fetched &after) {
    Rgb8 change = after.radiance - before.radiance,
         radiance = before.radiance + change * broadcast(from.share);
    Float8 bright = brightest(radiance) * from.exposure,
           differs = max(brightest(change), -min(change.x, min(change.y, change.z))) * from.exposure;
    return {radiance,
            differs <= fmadd(bright, 4.f, 0.1f) * (any(bright > trust.brightest) ? -1 : trust.tolerance)};
}

// Eight pixels from the pictures: radiance, which of them are done, and kInside where one shape fills them.
struct Reused {
    Rgb8 radiance = {};
    Int8 done = {}, inside = {};
};

// Joins both pictures' colours of a shape, in the active lanes. At a rim only mixed pixels count.
[[gnu::noinline]] void join(const Sources &from, const Trust &trust, Int8 active, bool rim, const Fetched &v,
                            const Fetched &w, Reused &reused) {
    Int8 before = v.coverage, after = w.coverage;
    // Only mixed pixels mark the shape's outline
    if (rim) before &= before == 1, after &= after == 1;
    Blend both = blend(from, trust, v, w);
    Int8 agree = (before > 0) & (after > 0) & both.agrees;
    Rgb8 radiance =
        select(agree | (before == after), both.radiance, select(before > after, v.radiance, w.radiance));
    // Retrace mixed pixels of objects much brighter than white. A small part of such an object makes a pixel
    // white, so interpolation would widen its outline
    Int8 blinding = ((before == 1) | (after == 1)) & (brightest(radiance) * from.exposure > kBlinding);
    reused.radiance = select(active, radiance, reused.radiance);
    reused.inside = select(active, (before & after) >> 1 << 12, reused.inside);
    reused.done |= active & (agree | ((before != after) & trust.alone)) & ~blinding;
}

// Makes eight pixels of a tile from (x, y) on: first from nearer shapes that extend into them from
// neighbouring pixels, then from the shapes that their own rays hit.
ODRAZ_INLINE Reused fetchPixels(const Sources &from, const Tile &t, const BetweenScratch &b, int x, int y) {
    const int at = (y + 1) * kRow + x + 1, sky = t.scene.shapeCount;
    Int8 shape = loadInts(b.shape + at), front = shape;
    Float8 along = load(b.along + at), nearest = select(shape == sky, kInfinity, along);
    // Find nearer shapes in neighbouring pixels: they may extend into pixels whose rays miss them
    static constexpr int kNeighbours[4] = {-1, 1, -kRow, kRow};
    Int8 edge = {};
    for (int step : kNeighbours) edge |= loadInts(b.shape + at + step) ^ shape;
    for (int step : kNeighbours) {
        if (!any(edge != 0)) break;
        Int8 other = loadInts(b.shape + at + step);
        Float8 distance = load(b.along + at + step);
        Int8 nearer = (other != shape) & (other != sky) & (distance < nearest);
        front = select(nearer, other, front);
        nearest = select(nearer, distance, nearest);
    }
    Float8 px = toFloat(kLanes) + ((float)(t.x0 + x) + 0.5f);
    float py = (float)(t.y0 + y) + 0.5f;
    Reused reused;
    bool rim = any(front != shape);
    Int8 carried = rim ? front : shape, lanes = rim ? front != shape : kLanes >= 0;
    Float8 distance = rim ? nearest : along;
    for (;;) {
        for (int left = laneBits(lanes); left;) {
            int id = carried[__builtin_ctz((unsigned)left)];
            Int8 same = lanes & (carried == id);
            left &= ~laneBits(same);
            Fetched before = fetchCarried(from.before, from.carry[0][id], px, py, distance),
                    after = fetchCarried(from.after, from.carry[1][id], px, py, distance);
            join(from, from.trust[id], same, rim, before, after, reused);
        }
        if (!rim) return reused;
        rim = false;
        carried = shape, lanes = ~reused.done, distance = along;
    }
}

// Whether all pixels of a block, and those around it, show the same shape.
ODRAZ_INLINE bool isPlain(const int32_t *shape) {
    Int8 first = broadcast(*shape), edge = {};
    for (int y = 0; y < kBlock + 2; ++y, shape += kRow)
        edge |= (loadInts(shape) ^ first) | (loadInts(shape + 2) ^ first);
    return !any(edge != 0);
}

// Where a plain block's pixels are in a traced picture: the upper row, and the step to the next row.
struct BlockRows {
    Float8 x, y, stepX, stepY;

    // v: the corners' coordinates: upper left and right, lower left and right.
    ODRAZ_INLINE static void spread(const float *v, Float8 &upper, Float8 &step) {
        constexpr float kPerStep = 1.f / (kBlock - 1);
        float across = (v[1] - v[0]) * kPerStep;
        upper = fmadd(toFloat(kLanes), across, broadcast(v[0]));
        step = fmadd(toFloat(kLanes), ((v[3] - v[2]) * kPerStep - across) * kPerStep,
                     broadcast((v[2] - v[0]) * kPerStep));
    }
};
// Computes these. Returns false if a corner is outside its picture.
ODRAZ_INLINE bool carryCorners(const Sources &from, int id, float px, float py, const float *along,
                               BlockRows (&rows)[2]) {
    constexpr int kEnd = kBlock - 1;
    const Carry &c = from.carry[0][id], &d = from.carry[1][id];
    Float8 x = px + Float8{0, kEnd, 0, kEnd, 0, kEnd, 0, kEnd},
           y = py + Float8{0, 0, kEnd, kEnd, 0, 0, kEnd, kEnd};
    __m128 four = {along[0], along[kEnd], along[kEnd * kRow], along[kEnd * kRow + kEnd]};
    Float8 distance = _mm256_set_m128(four, four);
    auto row = [&](const float(&h)[4], const float(&k)[4]) {
        Float8 both = _mm256_set_m128(_mm_loadu_ps(k), _mm_loadu_ps(h));
        Float8 part = fmadd(y, (Float8)_mm256_permute_ps(both, 0xaa), (Float8)_mm256_permute_ps(both, 0));
        return fmadd(distance, fmadd(x, (Float8)_mm256_permute_ps(both, 0x55), part),
                     (Float8)_mm256_permute_ps(both, 0xff));
    };
    Float8 ahead = row(c.h[2], d.h[2]);
    if (any(ahead <= kAhead)) return false;
    Float8 inverse = 1.f / ahead;
    x = fmadd(row(c.h[0], d.h[0]), inverse, -0.5f), y = fmadd(row(c.h[1], d.h[1]), inverse, -0.5f);
    float across[8], down[8];
    store(across, x), store(down, y);
    for (int i = 0; i < 2; ++i) {
        BlockRows::spread(across + 4 * i, rows[i].x, rows[i].stepX);
        BlockRows::spread(down + 4 * i, rows[i].y, rows[i].stepY);
    }
    const Frame &f = from.before, &g = from.after;
    return !any((min(x, y) < 0.f) | (x > (float)min(f.width, g.width) - 1.01f) |
                (y > (float)min(f.height, g.height) - 1.01f));
}

ODRAZ_INLINE void put(const Tile &t, int x, int y, const Rgb8 &v) {
    size_t out = (size_t)(t.y0 + y) * (size_t)t.frame.stride + (size_t)(t.x0 + x);
    store(t.frame.plane[0] + out, v.x);
    store(t.frame.plane[1] + out, v.y);
    store(t.frame.plane[2] + out, v.z);
}

// Makes a block of pixels. Appends the numbers of those to be traced to b.retraced; returns the new count.
ODRAZ_INLINE int makeBlock(const Sources &from, const Tile &t, BetweenScratch &b, int x, int top, int count) {
    const int at = top * kRow + x, id = b.shape[at];
    BlockRows rows[2];
    bool plain =
        isPlain(b.shape + at) && carryCorners(from, id, (float)(t.x0 + x) + 0.5f, (float)(t.y0 + top) + 0.5f,
                                              b.along + at + kRow + 1, rows);
    for (int y = top; y < min(top + kBlock, t.height); ++y) {
        Reused reused;
        if (plain) {
            Float8 down = broadcast((float)(y - top));
            auto fetchRow = [&](const Frame &f, int i) {
                const BlockRows &r = rows[i];
                return fetch(f, from.carry[i][id].shape, fmadd(r.stepX, down, r.x),
                             fmadd(r.stepY, down, r.y));
            };
            Fetched before = fetchRow(from.before, 0), after = fetchRow(from.after, 1);
            Blend both = blend(from, from.trust[id], before, after);
            if (laneBits(both.agrees & ((before.coverage & after.coverage) > 1)) == 255) {
                put(t, x, y, both.radiance);
                continue;
            }
            join(from, from.trust[id], kLanes >= 0, false, before, after, reused);
        } else
            reused = fetchPixels(from, t, b, x, y);
        put(t, x, y, reused.radiance);
        for (int left = laneBits(~reused.done & (kLanes < t.width - x)); left; left &= left - 1) {
            int lane = __builtin_ctz((unsigned)left);
            b.retraced[count++] = (uint16_t)(y * kTile + x + lane + reused.inside[lane]);
        }
    }
    return count;
}

void makeTile(const void *with, Tile &t, int worker) {
    const Sources &from = *(const Sources *)with;
    BetweenScratch &b = from.scratch[worker];
    int count = 0;
    findShapes(t, b);
    for (int y = 0; y < t.height; y += kBlock)
        for (int x = 0; x < t.width && count <= kMaxRetraced; x += kBlock)
            count = makeBlock(from, t, b, x, y, count);
    if (count > kMaxRetraced)
        traceAdaptive(t);
    else
        tracePixels(t, b.retraced, count);
}

} // namespace

const size_t kBetweenBytes = (kMaxShapes + 1) * (2 * sizeof(Carry) + sizeof(Trust)) +
                             kMaxWorkers * (sizeof(BetweenScratch) + 64) + 256;

bool makeBetween(Between &between, Arena &arena, int workers) {
    between.scratch = arena.allocate<BetweenScratch>((size_t)workers);
    for (Carry *&carry : between.carry) carry = arena.allocate<Carry>(kMaxShapes + 1);
    between.trust = arena.allocate<Trust>(kMaxShapes + 1);
    return !arena.full;
}

void traceBetween(Between &between, Tracer &tracer, Workers &workers, const Neighbours &n, Traced &now,
                  const Quality &quality) {
    carryTo(n.before, now, between.carry[0]);
    carryTo(n.after, now, between.carry[1]);
    findTrust(n.before, n.after, now, n.gap, between.carry, between.trust);
    Sources from = {n.before.frame, n.after.frame,       between.carry,  between.trust,
                    n.share,        now.scene->exposure, between.scratch};
    // Keep the depth and the cutoff: mirrors and glass must look as in the traced pictures, or they flicker.
    // But an in-between is shown for only a sixtieth of a second, so twice the thresholds are enough
    Quality relaxed = quality;
    relaxed.smallest = 8, relaxed.coarse = 32;
    relaxed.threshold *= 2, relaxed.markThreshold *= 2;
    relaxed.edge *= 2, relaxed.outline *= 2;
    forTiles(tracer, workers, *now.scene, now.view, relaxed, now.frame, {makeTile, &from});
}

} // namespace odraz
