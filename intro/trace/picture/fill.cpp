#include "trace/picture/fill.h"

#include "trace/shade/diffuse.h"

namespace odraz {

// Eight pixels of a row into the frame.
static void put(const Tile &t, int x, int y, const Rgb8 &v, Int8 owner) {
    size_t out = (size_t)(t.y0 + y) * (size_t)t.frame.stride + (size_t)(t.x0 + x);
    store(t.frame.plane[0] + out, v.x);
    store(t.frame.plane[1] + out, v.y);
    store(t.frame.plane[2] + out, v.z);
    for (int k = 0; t.frame.shapes && k < 8; ++k) t.frame.shapes[out + (size_t)k] = (uint16_t)owner[k];
}

// The albedo that eight pixels show. Noise of several octaves fades a little too early or too late; two by
// two samples of half the width are nearer to the truth.
static Rgb8 albedoOf(const Tile &t, uint16_t owner, int x, int y) {
    const Shape &shape = t.scene.shapes[owner];
    const Material &m = t.scene.materials[shape.material];
    Float8 px = toFloat(kLanes) + ((float)(t.x0 + x) + 0.5f), py = broadcast((float)(t.y0 + y) + 0.5f);
    if (t.quality.texels == 1 || !m.rough()) return albedoSeen(t.scene, t.view, shape, px, py, 1);
    Rgb8 sum = {};
    for (int i = 0; i < 4; ++i)
        sum += albedoSeen(t.scene, t.view, shape, px + ((float)(i & 1) * 0.5f - 0.25f),
                          py + ((float)(i >> 1) * 0.5f - 0.25f), 0.5f);
    return sum * broadcast(0.25f);
}

void fill(Tile &t, Square q, int size) {
    TileScratch &s = t.s;
    uint32_t c[4];
    int x0 = q.x >> 2, y0 = q.y >> 2, at = y0 * kTile + x0;
    cornersOf(q, size, c);
    const Sample &first = s.corners[c[0]];
    bool same = alike(s, c) & kSameId;
    uint16_t owner = !same ? kMixed : first.id ? (uint16_t)first.shape() : kSky;
    __m128 light[4], rest[4];
    for (int i = 0; i < 4; ++i) {
        const Sample &k = s.corners[c[i]];
        light[i] = same ? fourOf(k.light) : _mm_setzero_ps();
        rest[i] = same ? fourOf(k.rest) : radianceOf(k);
    }
    if (size == 4) {
        __m128 l = (light[0] + light[1] + light[2] + light[3]) * 0.25f;
        __m128 r = (rest[0] + rest[1] + rest[2] + rest[3]) * 0.25f;
        for (int k = 0; k < 3; ++k) s.light[k][at] = l[k], s.rest[k][at] = r[k];
        s.owner[at] = owner;
        return;
    }
    // A row of the square is one packet; along it and down the sides everything is linear
    int pixels = size >> 2;
    Int8 inside = kLanes < pixels;
    Float8 u = (toFloat(kLanes) + 0.5f) * (1.f / (float)pixels);
    for (int y = 0; y < pixels && y0 + y < t.height; ++y) {
        float v = ((float)y + 0.5f) / (float)pixels;
        auto row = [&](const __m128(&k)[4]) {
            __m128 left = k[0] + (k[2] - k[0]) * v, step = k[1] + (k[3] - k[1]) * v - left;
            return Rgb8{fmadd(u, step[0], broadcast(left[0])), fmadd(u, step[1], broadcast(left[1])),
                        fmadd(u, step[2], broadcast(left[2]))};
        };
        Rgb8 l = row(light), r = row(rest);
        int p = at + y * kTile;
        if (pixels == 8) {
            // Whole packets need not wait for their neighbours
            if (owner < kDone) r += l * albedoOf(t, owner, x0, y0 + y);
            put(t, x0, y0 + y, r, broadcast((int32_t)owner));
            _mm_storeu_si128((__m128i *)(s.owner + p), _mm_set1_epi16((short)kDone));
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            _mm256_maskstore_ps(s.light[k] + p, (__m256i)inside, (k == 0 ? l.x : k == 1 ? l.y : l.z));
            _mm256_maskstore_ps(s.rest[k] + p, (__m256i)inside, (k == 0 ? r.x : k == 1 ? r.y : r.z));
        }
        for (int x = 0; x < pixels; ++x) s.owner[p + x] = owner;
    }
}

void finishTile(Tile &t) {
    TileScratch &s = t.s;
    for (int y = 0; y < t.height; ++y)
        for (int x = 0; x < t.width; x += 8) {
            const int p = y * kTile + x;
            Rgb8 sum = {load(s.rest[0] + p), load(s.rest[1] + p), load(s.rest[2] + p)};
            if (s.owner[p] == kDone) continue;
            Int8 owner = (Int8)_mm256_cvtepu16_epi32(_mm_loadu_si128((const __m128i *)(s.owner + p)));
            int left = laneBits((owner < kDone) & (kLanes < t.width - x));
            if (left) {
                Rgb8 light = {load(s.light[0] + p), load(s.light[1] + p), load(s.light[2] + p)};
                while (left) {
                    int shape = owner[__builtin_ctz((unsigned)left)];
                    Int8 mine = owner == shape;
                    Rgb8 a = albedoOf(t, (uint16_t)shape, x, y);
                    sum = select(mine, sum + a * light, sum);
                    left &= ~laneBits(mine);
                }
            }
            put(t, x, y, sum, owner);
        }
}

} // namespace odraz
