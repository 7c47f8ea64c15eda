#include "trace/tile.h"

namespace odraz {

// What a pixel gets: radiance `rest` and `light` on the surface of the shape `owner`, or of none (kMixed).
static void setPixel(TileScratch &s, int p, Rgb light, Rgb rest, uint16_t owner) {
    s.light[0][p] = light.x, s.light[1][p] = light.y, s.light[2][p] = light.z;
    s.rest[0][p] = rest.x, s.rest[1][p] = rest.y, s.rest[2][p] = rest.z;
    s.owner[p] = owner;
}

void fill(Tile &t, Square q, int size) {
    TileScratch &s = t.s;
    int c[4];
    cornersOf(q, size, c);
    const Sample &first = s.corners[c[0]];
    bool same = !onSilhouette(s, c);
    Rgb light[4], rest[4];
    for (int i = 0; i < 4; ++i) {
        const Sample &k = s.corners[c[i]];
        light[i] = same ? k.light : Rgb{};
        rest[i] = same ? k.rest : k.radiance();
    }
    uint16_t owner = same && first.id ? (uint16_t)first.shape() : kMixed;
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
        setPixel(s, p, light, rest, same ? (uint16_t)corner.shape() : kMixed);
    }
}

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
            Rgb sum = {}, seen[kChunk];
            const Rgb *v[kChunk];
            for (int k = 0; k < perPixel; ++k) {
                Rgb c = s.fine[i * perPixel + k].radiance();
                seen[k] = shown(t.scene, c);
                v[k] = &seen[k];
                sum += c;
            }
            int p = s.pixels[first + i];
            setPixel(s, p, {}, sum * (1.f / (float)perPixel), kMixed);
            if (range(v, perPixel) > threshold) s.pixels[left++] = (uint16_t)p;
        }
    }
    return left;
}

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

} // namespace odraz
