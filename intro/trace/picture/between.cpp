#include "trace/picture/between.h"

#include "trace/picture/adaptive.h"
#include "trace/picture/carry.h"
#include "trace/picture/tiles.h"

namespace odraz {

// How far two pictures are trusted where they show a shape.
struct Trust {
    float alike;  // differences below this count as none
    int alone;    // -1: what one of them shows counts where the other one does not show it; 0: it does not
    float bright; // eight pixels count only if none of them is brighter, times white
};

namespace {

constexpr int kRow = kTile + 16, kRows = kTile + 2; // pixels of a tile and a border of one, and room behind
constexpr int kApart = 8;                           // rows are always traced at this distance; a power of two
constexpr int kBlock = 8;                           // pixels along a side that are carried by their corners
// Differences below this count as none in pictures two sixtieths of a second apart; in those further apart
// larger ones do, but in a flat mirror only up to kAlikeInFloor.
constexpr float kAlike = 0.06f, kAlikeInFloor = 0.09f;
// How far a mirrored thing moves across a ball between the pictures, as seen from the eye, in radians.
// Beyond kTorn, parts of the ball that only one picture shows do not count. Beyond kGhosts less difference
// is allowed: both pictures may show the same colour on either side of a thing that has moved. What glass
// shows moves up to twenty times as fast: kTornInGlass is kTorn for glass of any shape.
constexpr float kTorn = 0.0028f, kTornInGlass = 0.00014f, kGhosts = 0.0055f;
// What a flat mirror shows of lamps slides over it: both pictures may show the same of them where they are
// not. So nothing this bright is carried, if the eye moves by more than this part of its distance
constexpr float kBright = 0.25f, kSlides = 0.2f;
constexpr float kBlinding = 2.5f; // times white
// Samples in a pixel that is traced again: how many, and how far apart across and down
constexpr int kSamples = 3;
constexpr float kAside = 0.33f;
constexpr float kFetchedShare = 0.2f;        // of such a pixel's radiance
constexpr int kInside = kTile * kTile;       // added to the number of a pixel that one shape fills
constexpr int kMostAnew = kTile * kTile / 8; // pixels; a tile with more is traced as a whole

} // namespace

struct BetweenScratch {
    int64_t anew;
    // From one pixel up and left of the tile on: the shape seen, and how far along direction()
    int32_t shape[kRows * kRow];
    float along[kRows * kRow];
    uint16_t anewAt[kMostAnew + kBlock * kBlock]; // numbers of pixels
};

namespace {

// The two pictures, and how every shape is carried to them.
struct Sides {
    const Frame &before, &after;
    Carry *const (&carry)[2];
    const Trust *trust;
    float share; // of the later one
    float exposure;
    BetweenScratch *scratch; // one a worker
};

[[gnu::cold]] void findTrust(const Traced &before, const Traced &after, const Traced &now, float gap,
                             Carry *const (&carry)[2], Trust *trust) {
    const Scene &scene = *now.scene;
    // Beside a cut one picture stands for both, and its distance from now counts
    const bool one = before.scene == after.scene;
    for (int i = 0; i <= scene.shapeCount; ++i) {
        const Shape &a = scene.shapes[i];
        const Material &m = scene.materials[a.material];
        trust[i] = {kAlike * gap * 0.5f, -1, kInfinity};
        if (i == scene.shapeCount || carry[0][i].shape == kNone || carry[1][i].shape == kNone) continue;
        const bool glass = m.ior > 0;
        // What slides over a flat mirror is not known
        if (m.reflect > 0 && !a.isBall()) {
            trust[i].alike = min(trust[i].alike, kAlikeInFloor);
            if (length(after.view.eye - before.view.eye) >
                kSlides * abs(dot(now.view.eye - a.centre, a.frame.v)))
                trust[i].bright = kBright, trust[i].alone = 0;
        }
        if (!glass && (m.reflect <= 0 || !a.isBall())) continue;
        Vec3 u = before.scene->shapes[carry[0][i].shape].centre - before.view.eye,
             v = one ? a.centre - now.view.eye
                     : after.scene->shapes[carry[1][i].shape].centre - after.view.eye;
        float perLength = 1 / length(u);
        // The normal turns by half the angle by which the eye goes round the ball
        float moves = length(u * perLength - v * (1 / length(v))) * 0.5f * a.half.x * perLength;
        if (!glass) trust[i].alike *= min(kGhosts / max(moves, 1e-6f), 1.f);
        if (moves <= (glass ? kTornInGlass : kTorn)) continue;
        trust[i].alone = 0;
        if (one) trust[i].alike = -1;
    }
}

// Traces pixels: with one sample in the middle where one shape fills them, else with kSamples, each in a row
// and a column of its own.
void traceAnew(Tile &t, const uint16_t *pixels, int count) {
    TileScratch &s = t.s;
    const __m128 white = _mm_set1_ps(whiteOf(t.scene));
    for (int n; count > 0; count -= n, pixels += n) {
        n = min(count, kChunk / kSamples);
        int samples = 0;
        for (int i = 0; i < n; ++i)
            for (int k = -1; k < 2; ++k) {
                bool inside = pixels[i] >= kInside;
                int across = k, down = k == 1 ? -1 : k + 1;
                float aside = inside ? 0 : kAside;
                s.x[samples] = (float)(t.x0 + pixels[i] % kTile) + 0.5f + (float)across * aside;
                s.y[samples] = (float)(t.y0 + pixels[i] / kTile % kTile) + 0.5f + (float)down * aside;
                s.index[samples] = (uint32_t)samples;
                ++samples;
                if (inside) break;
            }
        traceSamples(t.scene, t.view, t.quality, s.trace, {s.among, 0.5f, samples, s.x, s.y, s.index},
                     s.inside);
        s.sampleCount += samples;
        for (int i = 0, next = 0; i < n; ++i) {
            int each = pixels[i] >= kInside ? 1 : kSamples;
            ptrdiff_t at = (ptrdiff_t)s.y[next] * t.frame.stride + (ptrdiff_t)s.x[next];
            __m128 sum = {}, least = s.inside[next], most = least;
            for (int k = 0; k < each; ++k) {
                __m128 v = s.inside[next++];
                sum += _mm_min_ps(v, white);
                least = _mm_min_ps(least, v), most = _mm_max_ps(most, v);
            }
            float *const *plane = t.frame.plane;
            __m128 fetched = {plane[0][at], plane[1][at], plane[2][at], 0};
            // The fetched radiance makes these few samples less noisy. Where they miss something bright,
            // nothing of it may remain
            sum = _mm_max_ps(sum * (1 / (float)each), least) * (1 - kFetchedShare) +
                  _mm_max_ps(_mm_min_ps(fetched, most * 3), least) * kFetchedShare;
            for (int c = 0; c < 3; ++c) plane[c][at] = sum[c];
        }
    }
}

// Finds what every pixel of a tile and around it shows. Most rows lie between two that show the same, and
// take it from them. On planes 1 / along is linear. Something small that is missed in this way is in the
// traced pictures, so that the pixel is traced again.
ODRAZ_INLINE void findShown(const Tile &t, BetweenScratch &b) {
    const int sky = t.scene.shapeCount;
    const View &v = t.view;
    for (int apart = kApart; apart; apart >>= 1) {
        const int between = apart % kApart; // 0 in the first round, whose rows lie between none
        for (int y = between; y < kRows; y += apart + between)
            for (int x = 0; x < kTile + 2; x += 8) {
                int32_t *shape = b.shape + y * kRow + x;
                float *along = b.along + y * kRow + x;
                int beside = y + between < kRows ? between * kRow : 0;
                Int8 same = loadInts(shape - beside);
                if (beside && !any(same != loadInts(shape + beside))) {
                    store(shape, same);
                    Float8 above = load(along - beside), below = load(along + beside);
                    store(along, above * below * 2.f / (above + below));
                    continue;
                }
                Vec3x8 d = v.direction(toFloat(kLanes) + ((float)(t.x0 + x) - 0.5f),
                                       broadcast((float)(t.y0 + y) - 0.5f));
                Float8 perLength = 1.f / length(d);
                Hit8 hit = intersect(t.scene, t.s.among, v.eye, d * perLength, kLanes >= 0);
                Int8 none = hit.shape < 0;
                store(shape, select(none, broadcast(sky), hit.shape));
                store(along, select(none, 1.f, hit.t * perLength));
            }
    }
}

Float8 brightest(const Rgb8 &v) { return max(v.x, max(v.y, v.z)); }

// Between what both pictures show, and where that differs by roughly less than the eye sees.
struct Blend {
    Rgb8 radiance;
    Int8 agrees;
};
ODRAZ_INLINE Blend blend(const Sides &sides, const Trust &trust, const Fetched &before,
                         const Fetched &after) {
    Rgb8 off = after.radiance - before.radiance, radiance = before.radiance + off * broadcast(sides.share);
    Float8 bright = brightest(radiance) * sides.exposure,
           differs = max(brightest(off), -min(off.x, min(off.y, off.z))) * sides.exposure;
    return {radiance, differs <= fmadd(bright, 4.f, 0.1f) * (any(bright > trust.bright) ? -1 : trust.alike)};
}

// What is known of eight pixels without tracing; and kInside where one shape fills them.
struct Known {
    Rgb8 radiance = {};
    Int8 done = {}, inside = {};
};

// Joins what both pictures show of a shape. At a rim only pixels of several shapes count.
[[gnu::noinline]] void join(const Sides &sides, const Trust &trust, Int8 mine, bool rim, const Fetched &v,
                            const Fetched &w, Known &known) {
    Int8 before = v.worth, after = w.worth;
    // Only pixels that it shares with other shapes show how far it extends
    if (rim) before &= before == 1, after &= after == 1;
    Blend both = blend(sides, trust, v, w);
    Int8 agree = (before > 0) & (after > 0) & both.agrees;
    Rgb8 radiance =
        select(agree | (before == after), both.radiance, select(before > after, v.radiance, w.radiance));
    // A pixel is white as soon as a little of something much brighter than white extends into it.
    // Interpolation would widen the outline of such a thing
    Int8 blinding = ((before == 1) | (after == 1)) & (brightest(radiance) * sides.exposure > kBlinding);
    known.radiance = select(mine, radiance, known.radiance);
    known.inside = select(mine, (before & after) >> 1 << 12, known.inside);
    known.done |= mine & (agree | ((before != after) & trust.alone)) & ~blinding;
}

// Eight pixels of a tile from (x, y) on: first nearer shapes that extend into them from the pixels beside
// them, then what their own rays hit.
ODRAZ_INLINE Known fetchPixels(const Sides &sides, const Tile &t, const BetweenScratch &b, int x, int y) {
    const int at = (y + 1) * kRow + x + 1, sky = t.scene.shapeCount;
    Int8 shape = loadInts(b.shape + at), front = shape;
    Float8 along = load(b.along + at), nearest = select(shape == sky, kInfinity, along);
    // Beside its outline, a nearer shape may extend into pixels whose rays miss it: they move with it
    static constexpr int kBeside[4] = {-1, 1, -kRow, kRow};
    Int8 edge = {};
    for (int step : kBeside) edge |= loadInts(b.shape + at + step) ^ shape;
    for (int step : kBeside) {
        if (!any(edge != 0)) break;
        Int8 other = loadInts(b.shape + at + step);
        Float8 way = load(b.along + at + step);
        Int8 nearer = (other != shape) & (other != sky) & (way < nearest);
        front = select(nearer, other, front);
        nearest = select(nearer, way, nearest);
    }
    Float8 px = toFloat(kLanes) + ((float)(t.x0 + x) + 0.5f);
    float py = (float)(t.y0 + y) + 0.5f;
    Known known;
    bool rim = any(front != shape);
    Int8 whose = rim ? front : shape, lanes = rim ? front != shape : kLanes >= 0;
    Float8 far = rim ? nearest : along;
    for (;;) {
        for (int left = laneBits(lanes); left;) {
            int id = whose[__builtin_ctz((unsigned)left)];
            Int8 mine = lanes & (whose == id);
            left &= ~laneBits(mine);
            Fetched before = fetchFar(sides.before, sides.carry[0][id], px, py, far),
                    after = fetchFar(sides.after, sides.carry[1][id], px, py, far);
            join(sides, sides.trust[id], mine, rim, before, after, known);
        }
        if (!rim) return known;
        rim = false;
        whose = shape, lanes = ~known.done, far = along;
    }
}

// Whether a block and those around it show the same shape.
ODRAZ_INLINE bool isPlain(const int32_t *shape) {
    Int8 first = broadcast(*shape), edge = {};
    for (int y = 0; y < kBlock + 2; ++y, shape += kRow)
        edge |= (loadInts(shape) ^ first) | (loadInts(shape + 2) ^ first);
    return !any(edge != 0);
}

// Where the corners of a plain block lie in both pictures: upper left and right, lower left and right; then
// in the later one.
struct Corners {
    float x[8], y[8];

    // Places of a row of the block, from corner `first` on.
    ODRAZ_INLINE static Float8 row(const float *v, float down) {
        float left = v[0] + (v[2] - v[0]) * down, right = v[1] + (v[3] - v[1]) * down;
        return fmadd(toFloat(kLanes), (right - left) * (1.f / (kBlock - 1)), broadcast(left));
    }
};
// False if one lies outside.
ODRAZ_INLINE bool carryCorners(const Sides &sides, int id, float px, float py, const float *along,
                               Corners &corners) {
    constexpr int kEnd = kBlock - 1;
    const Carry &c = sides.carry[0][id], &d = sides.carry[1][id];
    Float8 x = px + Float8{0, kEnd, 0, kEnd, 0, kEnd, 0, kEnd},
           y = py + Float8{0, 0, kEnd, kEnd, 0, 0, kEnd, kEnd};
    __m128 four = {along[0], along[kEnd], along[kEnd * kRow], along[kEnd * kRow + kEnd]};
    Float8 far = _mm256_set_m128(four, four);
    auto row = [&](const float(&h)[4], const float(&k)[4]) {
        Float8 both = _mm256_set_m128(_mm_loadu_ps(k), _mm_loadu_ps(h));
        Float8 way = fmadd(y, (Float8)_mm256_permute_ps(both, 0xaa), (Float8)_mm256_permute_ps(both, 0));
        return fmadd(far, fmadd(x, (Float8)_mm256_permute_ps(both, 0x55), way),
                     (Float8)_mm256_permute_ps(both, 0xff));
    };
    Float8 ahead = row(c.h[2], d.h[2]);
    if (any(ahead <= kAhead)) return false;
    Float8 inverse = 1.f / ahead;
    x = fmadd(row(c.h[0], d.h[0]), inverse, -0.5f), y = fmadd(row(c.h[1], d.h[1]), inverse, -0.5f);
    store(corners.x, x);
    store(corners.y, y);
    const Frame &f = sides.before, &g = sides.after;
    return !any((min(x, y) < 0.f) | (x > (float)min(f.width, g.width) - 1.01f) |
                (y > (float)min(f.height, g.height) - 1.01f));
}

ODRAZ_INLINE void put(const Tile &t, int x, int y, const Rgb8 &v) {
    size_t out = (size_t)(t.y0 + y) * (size_t)t.frame.stride + (size_t)(t.x0 + x);
    store(t.frame.plane[0] + out, v.x);
    store(t.frame.plane[1] + out, v.y);
    store(t.frame.plane[2] + out, v.z);
}

// Makes a block, and adds the numbers of the pixels that must be traced.
ODRAZ_INLINE int makeBlock(const Sides &sides, const Tile &t, BetweenScratch &b, int x, int top, int count) {
    const int at = top * kRow + x, id = b.shape[at];
    Corners c;
    bool plain =
        isPlain(b.shape + at) && carryCorners(sides, id, (float)(t.x0 + x) + 0.5f, (float)(t.y0 + top) + 0.5f,
                                              b.along + at + kRow + 1, c);
    for (int y = top; y < min(top + kBlock, t.height); ++y) {
        Known known;
        if (plain) {
            float down = (float)(y - top) * (1.f / (kBlock - 1));
            Fetched before = fetch(sides.before, sides.carry[0][id].shape, Corners::row(c.x, down),
                                   Corners::row(c.y, down)),
                    after = fetch(sides.after, sides.carry[1][id].shape, Corners::row(c.x + 4, down),
                                  Corners::row(c.y + 4, down));
            Blend both = blend(sides, sides.trust[id], before, after);
            if (laneBits(both.agrees & ((before.worth & after.worth) > 1)) == 255) {
                put(t, x, y, both.radiance);
                continue;
            }
            join(sides, sides.trust[id], kLanes >= 0, false, before, after, known);
        } else
            known = fetchPixels(sides, t, b, x, y);
        put(t, x, y, known.radiance);
        for (int left = laneBits(~known.done & (kLanes < t.width - x)); left; left &= left - 1) {
            int lane = __builtin_ctz((unsigned)left);
            b.anewAt[count++] = (uint16_t)(y * kTile + x + lane + known.inside[lane]);
        }
    }
    return count;
}

void makeTile(const void *with, Tile &t, int worker) {
    const Sides &sides = *(const Sides *)with;
    BetweenScratch &b = sides.scratch[worker];
    int count = 0;
    findShown(t, b);
    for (int y = 0; y < t.height; y += kBlock)
        for (int x = 0; x < t.width && count <= kMostAnew; x += kBlock)
            count = makeBlock(sides, t, b, x, y, count);
    if (count > kMostAnew)
        traceAdaptive(t), count = t.width * t.height;
    else
        traceAnew(t, b.anewAt, count);
    b.anew += count;
}

} // namespace

const size_t kBetweenBytes = (kMaxShapes + 1) * (2 * sizeof(Carry) + sizeof(Trust)) +
                             kMaxWorkers * (sizeof(BetweenScratch) + 64) + 256;

bool makeBetween(Between &between, Arena &arena, int workers) {
    between.workers = workers;
    between.scratch = arena.take<BetweenScratch>((size_t)workers);
    for (Carry *&carry : between.carry) carry = arena.take<Carry>(kMaxShapes + 1);
    between.trust = arena.take<Trust>(kMaxShapes + 1);
    return !arena.full;
}

void traceBetween(Between &between, Tracer &tracer, Workers &workers, const Neighbours &n, Traced &now,
                  const Quality &quality) {
    carryTo(n.before, now, between.carry[0]);
    carryTo(n.after, now, between.carry[1]);
    findTrust(n.before, n.after, now, n.gap, between.carry, between.trust);
    Sides sides = {n.before.frame, n.after.frame,       between.carry,  between.trust,
                   n.share,        now.scene->exposure, between.scratch};
    // Mirrors and glass must look as in the traced pictures, or they flicker. But an in-between is seen for
    // a sixtieth of a second only, so twice the thresholds are enough
    Quality anew = quality;
    anew.fine = max(anew.fine, 2), anew.coarse = 32;
    anew.threshold *= 2, anew.markThreshold *= 2, anew.edge *= 2;
    forTiles(tracer, workers, *now.scene, now.view, anew, now.frame, makeTile, &sides);
}

int64_t tracedAnew(Between &between) {
    int64_t pixels = 0;
    for (int i = 0; i < between.workers; ++i) pixels += between.scratch[i].anew, between.scratch[i].anew = 0;
    return pixels;
}

} // namespace odraz
