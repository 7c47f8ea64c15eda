#include "trace/picture/fill.h"

#include "trace/picture/criterion.h"
#include "trace/shade/diffuse.h"

namespace odraz {

// Writes eight pixels of a row to the frame, with their shapes.
static void put(const Tile &t, int x, int y, const Rgb8 &v, __m128i shapes) {
    size_t out = (size_t)(t.y0 + y) * (size_t)t.frame.stride + (size_t)(t.x0 + x);
    store(t.frame.plane[0] + out, v.x);
    store(t.frame.plane[1] + out, v.y);
    store(t.frame.plane[2] + out, v.z);
    if (t.frame.shapes) _mm_storeu_si128((__m128i *)(t.frame.shapes + out), shapes);
}

// The albedo of a shape at eight pixels; `active` are those that show it. Where it changes from one pixel to
// the next, one sample is inexact: noise fades a little too early or too late, and lines have stairs. There
// the mean of two by two samples of half the width is taken. A single sample comes closest to it if 0.7 wide.
static Rgb8 albedoOf(const Tile &t, uint16_t id, int x, int y, Int8 active) {
    const Shape &shape = t.scene.shapes[id];
    const Material &m = t.scene.materials[shape.material];
    if (onePlainColour(t.scene, m)) return broadcast(m.texture.palette[0] * m.diffuse);
    Float8 px = toFloat(kLanes) + ((float)(t.x0 + x) + 0.5f), py = broadcast((float)(t.y0 + y) + 0.5f);
    Rgb8 one = albedoSeen(t.scene, t.view, shape, px, py, 0.7f);
    Float8 next = _mm256_permutevar8x32_ps(one.y, (__m256i)Int8{1, 2, 3, 4, 5, 6, 7, 7});
    if (!any(active & (abs(next - one.y) >= next * t.quality.textureEdge))) return one;
    Rgb8 sum = {};
    for (int i = 0; i < 4; ++i)
        sum += albedoSeen(t.scene, t.view, shape, px + ((float)(i & 1) * 0.5f - 0.25f),
                          py + ((float)(i >> 1) * 0.5f - 0.25f), 0.5f);
    return sum * broadcast(0.25f);
}

// Interpolates between values at the corners of a square, linearly along its rows and sides.
struct Bilinear {
    __m128 left, right, down, downRight;

    explicit Bilinear(const __m128 (&k)[4])
        : left(k[0]), right(k[1]), down(k[2] - k[0]), downRight(k[3] - k[1]) {}
    // Values in the row at v, at positions u along it, 0 .. 1.
    ODRAZ_INLINE Rgb8 row(__m128 v, Float8 u) const {
        __m128 first = left + down * v, step = right + downRight * v - first;
        return {fmadd(u, step[0], broadcast(first[0])), fmadd(u, step[1], broadcast(first[1])),
                fmadd(u, step[2], broadcast(first[2]))};
    }
};

// Keeps a row of fewer than eight pixels until its neighbours are filled, too.
ODRAZ_INLINE static void keepRow(float (&to)[3][kTile * kTile + 8], int p, int size, const Rgb8 &v) {
    Int8 inside = kLanes < size;
    _mm256_maskstore_ps(to[0] + p, (__m256i)inside, v.x);
    _mm256_maskstore_ps(to[1] + p, (__m256i)inside, v.y);
    _mm256_maskstore_ps(to[2] + p, (__m256i)inside, v.z);
}

// The order in which the albedo of eight rows is computed. Three are evaluated; the others are interpolated,
// unless the albedo changes from the row above to the row below.
static constexpr struct {
    uint8_t row, above, below;
} kRowOrder[] = {{0, 0, 0}, {4, 0, 0}, {7, 0, 0}, {2, 0, 4}, {6, 4, 7}, {1, 0, 2}, {3, 2, 4}, {5, 4, 6}};

// Finds the albedo of the rows of a square of eight by eight pixels.
ODRAZ_INLINE static void albedoOfRows(const Tile &t, uint16_t shape, Square q, Rgb8 (&albedo)[8]) {
    for (const auto &[y, above, below] : kRowOrder) {
        const Rgb8 &a = albedo[above], &b = albedo[below];
        albedo[y] = below == 0 || any(abs(b.y - a.y) >= a.y * (t.quality.textureEdge * 0.025f))
                        ? albedoOf(t, shape, q.x, q.y + y, kLanes >= 0)
                        : a + (b - a) * broadcast((float)(y - above) / (float)(below - above));
    }
}

// Keeps a pixel: the means of its corners' light and rest, no corner brighter than white.
ODRAZ_INLINE static void keepPixel(const Tile &t, const __m128 (&light)[4], __m128 (&rest)[4], int at) {
    __m128 l = (light[0] + light[1] + light[2] + light[3]) * 0.25f;
    __m128 white = _mm_set1_ps(whiteOf(t.scene)), r = {}, darkest = rest[0];
    for (__m128 &v : rest) darkest = _mm_min_ps(darkest, v), v = _mm_min_ps(v, white), r += v * 0.25f;
    r = _mm_max_ps(r, darkest);
    for (int k = 0; k < 3; ++k) t.s.light[k][at] = l[k], t.s.rest[k][at] = r[k];
}

void fill(Tile &t, Square q, int size) {
    TileScratch &s = t.s;
    uint32_t c[4];
    int x0 = q.x, y0 = q.y, at = y0 * kTile + x0;
    cornersOf(q, size, c);
    const Sample &first = s.corners[c[0]];
    bool same = alike(s, c) & kSameId;
    uint16_t shape = !same ? kMixed : first.id ? (uint16_t)first.shape() : kSky;
    bool lit = shape < kDone;
    __m128 light[4], rest[4];
    for (int i = 0; i < 4; ++i) {
        const Sample &k = s.corners[c[i]];
        light[i] = fourOf(k.light);
        rest[i] = lit ? fourOf(k.rest) : radianceOf(k);
    }
    if (size == 1) {
        keepPixel(t, light, rest, at);
        s.shape[at] = shape;
        return;
    }
    // Interpolate row by row; a row is one packet
    float step = 1.f / (float)size;
    Float8 u = (toFloat(kLanes) + 0.5f) * step;
    Bilinear lights(light), rests(rest);
    __m128i shapes = _mm_set1_epi16((short)shape);
    Rgb8 albedo[8];
    if (size == 8 && lit) albedoOfRows(t, shape, q, albedo);
    for (int y = 0; y < size && y0 + y < t.height; ++y) {
        __m128 v = _mm_set1_ps(((float)y + 0.5f) * step);
        Rgb8 r = rests.row(v, u);
        int p = at + y * kTile;
        if (size == 8) {
            // Write eight pixels at once; fewer wait for their neighbours
            if (lit) r += lights.row(v, u) * albedo[y];
            put(t, x0, y0 + y, r, shapes);
            _mm_storeu_si128((__m128i *)(s.shape + p), _mm_set1_epi16((short)kDone));
            continue;
        }
        keepRow(s.rest, p, size, r);
        if (lit) keepRow(s.light, p, size, lights.row(v, u));
        if (size == 4)
            _mm_storel_epi64((__m128i *)(s.shape + p), shapes);
        else
            _mm_storeu_si32(s.shape + p, shapes);
    }
}

void finishTile(Tile &t) {
    TileScratch &s = t.s;
    for (int y = 0; y < t.height; ++y)
        for (int x = 0; x < t.width; x += 8) {
            const int p = y * kTile + x;
            Rgb8 sum = {load(s.rest[0] + p), load(s.rest[1] + p), load(s.rest[2] + p)};
            if (s.shape[p] == kDone) continue;
            __m128i shapes = _mm_loadu_si128((const __m128i *)(s.shape + p));
            Int8 shape = (Int8)_mm256_cvtepu16_epi32(shapes);
            const Int8 inside = kLanes < t.width - x; // outside, s.shape is left from an earlier tile
            int left = laneBits((shape < kDone) & inside);
            if (left) {
                Rgb8 light = {load(s.light[0] + p), load(s.light[1] + p), load(s.light[2] + p)};
                while (left) {
                    int id = shape[__builtin_ctz((unsigned)left)];
                    Int8 same = (shape == id) & inside;
                    Rgb8 a = albedoOf(t, (uint16_t)id, x, y, same);
                    sum = select(same, sum + a * light, sum);
                    left &= ~laneBits(same);
                }
            }
            put(t, x, y, sum, shapes);
        }
}

} // namespace odraz
