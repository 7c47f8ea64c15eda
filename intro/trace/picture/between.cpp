#include "trace/picture/between.h"

#include "trace/picture/adaptive.h"
#include "trace/picture/tiles.h"

namespace odraz {

namespace {

constexpr int kRow = kTile + 16, kRows = kTile + 2; // pixels of a tile and a border of one, and room behind
constexpr int kApart = 8; // how far those rows are apart that are always looked at; a power of two
constexpr uint16_t kNone = 0xffff;
// Differences of what is shown below this count as none. What glass shows moves unlike the glass: where that
// moves fast, as when a ball crosses the lens, little is taken for alike
constexpr float kAlike = 0.06f, kAlikeInGlass = 0.03f;
constexpr float kFast = 0.05f;    // of a ball, in radii from picture to picture
constexpr float kBlinding = 2.5f; // times white
// Samples in a pixel that is traced anew: how many, and how far apart across and down
constexpr int kSamples = 3;
constexpr float kAside = 0.33f;
constexpr float kFetchedShare = 0.2f;        // of such a pixel's radiance
constexpr int kInside = kTile * kTile;       // added to the number of a pixel that one shape fills
constexpr int kMostAnew = kTile * kTile / 8; // pixels; a tile with more is traced as a whole

} // namespace

// Maps a pixel (x, y) of an in-between to a pixel of a traced picture. If the shape is hit at s times
// direction(x, y) from the eye, the homogeneous coordinates there are s * (h[0] + h[1] x + h[2] y) + h[3].
struct Carry {
    float h[3][4];
    float alike;    // differences of what it shows below this count as none
    uint16_t shape; // its index in that picture's scene; kNone: it is not there
};

struct BetweenScratch {
    int64_t anew;
    // From one pixel up and left of the tile on: the shape seen, and how far along direction()
    int32_t shape[kRows * kRow];
    float along[kRows * kRow];
    uint16_t anewAt[kTile * kTile]; // numbers of pixels
};

namespace {

// How all shapes of `now`, and behind the last of them the sky, map to another picture. Its scene may have
// some more shapes and lack some others, but their order is the same. A shape that is in both has hardly
// moved.
[[gnu::cold]] void carryTo(const Traced &to, const Traced &now, Carry *carry) {
    constexpr int kMostNew = 200;
    const View &v = to.view, &w = now.view;
    Vec3 rows[3] = {v.right * (v.width / dot(v.right, v.right)) + v.forward * (v.width * 0.5f),
                    v.down * (v.height / dot(v.down, v.down)) + v.forward * (v.height * 0.5f), v.forward};
    Vec3 from[3] = {w.direction(0.f, 0.f), w.right * (1 / w.width), w.down * (1 / w.height)};
    int next = 0;
    for (int i = 0; i <= now.scene->shapeCount; ++i) {
        const Shape &a = now.scene->shapes[i];
        Carry &c = carry[i];
        c = {};
        bool sky = i == now.scene->shapeCount;
        c.shape = sky ? kSkyShown : kNone;
        for (int j = next; !sky && j < min(next + kMostNew, to.scene->shapeCount); ++j) {
            Vec3 way = a.centre - to.scene->shapes[j].centre;
            if (a.kind != to.scene->shapes[j].kind || dot(way, way) > a.half.x * a.half.x * 0.25f) continue;
            c.shape = (uint16_t)j;
            next = j + 1;
            break;
        }
        if (c.shape == kNone) continue;
        c.alike = kAlike;
        const Shape &b = to.scene->shapes[sky ? 0 : c.shape];
        Vec3 moved = b.centre - v.eye - (a.centre - w.eye);
        if (!sky && now.scene->materials[a.material].ior > 0 &&
            dot(moved, moved) > a.half.x * a.half.x * (kFast * kFast))
            c.alike = kAlikeInGlass;
        for (int k = 0; k < 3; ++k) {
            Vec3 r = rows[k], turned = r;
            if (!sky) {
                // What a ball mirrors does not roll with it, nor do lights and shadows on it. So a ball turns
                // only if it has a texture
                if (a.traits().extents && !(a.isBall() && now.scene->materials[a.material].plain()))
                    turned = transposeTimes(a.frame, b.frame * r);
                if (a.half.x > 0) turned *= Vec3{1, 1, 1} * (b.half.x / a.half.x);
                c.h[k][3] = dot(turned, w.eye - a.centre) + dot(r, b.centre - v.eye);
            }
            for (int m = 0; m < 3; ++m) c.h[k][m] = dot(turned, from[m]);
        }
    }
}

// What a traced picture shows at eight places of a shape: radiance, and whether it is the shape's: 0 no, 1
// partly, 2 entirely.
struct Fetched {
    Rgb8 radiance;
    Int8 worth;
};

[[gnu::noinline]] Fetched fetch(const Frame &f, const Carry &c, Float8 px, float py, Float8 along) {
    auto row = [&](const float(&h)[4]) {
        return fmadd(along, fmadd(px, h[1], broadcast(fmadd(py, h[2], h[0]))), h[3]);
    };
    Float8 ahead = row(c.h[2]);
    Int8 mine = ahead > 1e-6f;
    Float8 inverse = 1.f / select(mine, ahead, 1.f);
    Float8 x = fmadd(row(c.h[0]), inverse, -0.5f), y = fmadd(row(c.h[1]), inverse, -0.5f);
    float right = (float)(f.width - 1) - 0.001f, bottom = (float)(f.height - 1) - 0.001f;
    Float8 inX = clamp(x, 0.f, right), inY = clamp(y, 0.f, bottom);
    mine &= max(abs(x - inX), abs(y - inY)) < 0.5f;
    Float8 left = floor(inX), top = floor(inY), u = inX - left, w = inY - top;
    // Neighbouring pixels are mostly neighbours there, too. So loads replace gathers, one round for each
    // distinct offset. (What lanes read beyond the end of a plane belongs to the next one.)
    Int8 step = toInt(fmadd(top, (float)f.stride, left)) - kLanes, others = {};
    Fetched found = {Rgb8{}, Int8{}};
    for (int rest = 255; rest;) {
        ptrdiff_t first = step[__builtin_ctz((unsigned)rest)];
        Int8 here = step == (int32_t)first;
        rest &= ~laneBits(here);
        // Find which shapes the four pixels around show, and interpolate their radiance
        Int8 owned = here;
        auto take = [&](const uint16_t *p) {
            Int8 id = (Int8)_mm256_cvtepu16_epi32(_mm_loadu_si128((const __m128i *)(p + first)));
            Int8 many = id == kManyShapes;
            owned &= many | (id == c.shape);
            others |= many & here;
        };
        take(f.shapes), take(f.shapes + 1), take(f.shapes + f.stride), take(f.shapes + f.stride + 1);
        auto mix = [&](const float *p) {
            p += first;
            Float8 a = load(p), b = load(p + f.stride);
            a = fmadd(u, load(p + 1) - a, a);
            b = fmadd(u, load(p + f.stride + 1) - b, b);
            return fmadd(w, b - a, a);
        };
        found.radiance =
            select(owned, Rgb8{mix(f.plane[0]), mix(f.plane[1]), mix(f.plane[2])}, found.radiance);
        found.worth |= owned;
    }
    found.worth &= mine & (2 + others);
    return found;
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
        traceSamples(t.scene, t.view, t.quality, s.trace, s.among, 0.5f, samples, s.x, s.y, s.index,
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
            // What was fetched makes so few samples less noisy. Where they miss something bright, nothing of
            // it may remain
            sum = _mm_max_ps(sum * (1 / (float)each), least) * (1 - kFetchedShare) +
                  _mm_max_ps(_mm_min_ps(fetched, most * 3), least) * kFetchedShare;
            for (int c = 0; c < 3; ++c) plane[c][at] = sum[c];
        }
    }
}

Float8 brightest(const Rgb8 &v) { return max(v.x, max(v.y, v.z)); }

// Finds what every pixel of a tile and around it shows. Most rows lie between two that show the same, and
// take it from them. On planes 1 / along is linear. Something
// small that is missed so stands in the traced pictures, and is traced anew.
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

// The two pictures, and how every shape is carried to them.
struct Sides {
    const Frame &before, &after;
    Carry *const (&carry)[2];
};

// What eight pixels show, as far as it is known without tracing; and kInside where one shape fills them.
struct Known {
    Rgb8 radiance = {};
    Int8 done = {}, inside = {};
};

// Fetches from both pictures what the lanes show, `far` along their directions.
// At a rim only pixels of several shapes count.
ODRAZ_INLINE void fetchBoth(const Sides &sides, Int8 whose, Int8 lanes, bool rim, Float8 px, float py,
                            Float8 far, float exposure, Known &known) {
    for (int left = laneBits(lanes); left;) {
        int id = whose[__builtin_ctz((unsigned)left)];
        Int8 mine = lanes & (whose == id);
        left &= ~laneBits(mine);
        const float alike = sides.carry[0][id].alike;
        Fetched v = fetch(sides.before, sides.carry[0][id], px, py, far),
                w = fetch(sides.after, sides.carry[1][id], px, py, far);
        Int8 before = v.worth, after = w.worth;
        // Only pixels that it shares with other shapes tell how far it extends
        if (rim) before &= before == 1, after &= after == 1;
        Rgb8 more = v.radiance + w.radiance, off = v.radiance - w.radiance;
        // They agree if they differ by roughly less than the eye sees
        Float8 bright = brightest(more) * (0.5f * exposure);
        Int8 agree = (before > 0) & (after > 0) &
                     (max(brightest(off), -min(off.x, min(off.y, off.z))) * exposure <=
                      fmadd(bright, fmadd(bright, 2.5f, broadcast(4.f)), 0.1f) * alike);
        more = select(agree | (before == after), more * broadcast(0.5f),
                      select(before > after, v.radiance, w.radiance));
        // A pixel is white as soon as a little of something much brighter than white extends into it.
        // Interpolation would widen the outline of such a thing
        Int8 blinding = ((before == 1) | (after == 1)) & (brightest(more) * exposure > kBlinding);
        known.radiance = select(mine, more, known.radiance);
        known.inside = select(mine, (before & after) >> 1 << 12, known.inside);
        known.done |= mine & (agree | (before != after)) & ~blinding;
    }
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
        fetchBoth(sides, whose, lanes, rim, px, py, far, t.scene.exposure, known);
        if (!rim) return known;
        rim = false;
        whose = shape, lanes = ~known.done, far = along;
    }
}

// Traces the pixels that anewAt lists, or the whole tile if there are many.
ODRAZ_INLINE void retrace(Tile &t, BetweenScratch &b, int count) {
    b.anew += count;
    if (count > kMostAnew)
        traceAdaptive(t);
    else
        traceAnew(t, b.anewAt, count);
}

void makeTile(const Sides &sides, Tile &t, BetweenScratch &b) {
    int count = 0;
    findShown(t, b);
    for (int y = 0; y < t.height; ++y)
        for (int x = 0; x < t.width; x += 8) {
            Known known = fetchPixels(sides, t, b, x, y);
            size_t out = (size_t)(t.y0 + y) * (size_t)t.frame.stride + (size_t)(t.x0 + x);
            const Float8 *channel[3] = {&known.radiance.x, &known.radiance.y, &known.radiance.z};
            for (int k = 0; k < 3; ++k) store(t.frame.plane[k] + out, *channel[k]);
            for (int left = laneBits(~known.done & (kLanes < t.width - x)); left; left &= left - 1) {
                int lane = __builtin_ctz((unsigned)left);
                b.anewAt[count++] = (uint16_t)(y * kTile + x + lane + known.inside[lane]);
            }
        }
    retrace(t, b, count);
}

} // namespace

const size_t kBetweenBytes =
    2 * (kMaxShapes + 1) * sizeof(Carry) + kMaxWorkers * (sizeof(BetweenScratch) + 64);

bool makeBetween(Between &between, Arena &arena, int workers) {
    between.workers = workers;
    between.scratch = arena.take<BetweenScratch>((size_t)workers);
    for (Carry *&carry : between.carry) carry = arena.take<Carry>(kMaxShapes + 1);
    return !arena.full;
}

void traceBetween(Between &between, Tracer &tracer, Workers &workers, const Traced &before,
                  const Traced &after, const Quality &quality, Traced &now) {
    carryTo(before, now, between.carry[0]);
    carryTo(after, now, between.carry[1]);
    Sides sides = {before.frame, after.frame, between.carry};
    forTiles(tracer, workers, *now.scene, now.view, quality, now.frame,
             [&](Tile &tile, int worker) { makeTile(sides, tile, between.scratch[worker]); });
}

int64_t tracedAnew(Between &between) {
    int64_t pixels = 0;
    for (int i = 0; i < between.workers; ++i) pixels += between.scratch[i].anew, between.scratch[i].anew = 0;
    return pixels;
}

} // namespace odraz
