#include "trace/picture/carry.h"

#include "base/parallel.h"

namespace odraz {

[[gnu::cold]] void carryTo(const Traced &to, const Traced &now, Carry *carry) {
    constexpr int kMostNew = 200; // most shapes of the later scene that are skipped in search of a match
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
            Vec3 move = a.centre - to.scene->shapes[j].centre;
            if (a.kind != to.scene->shapes[j].kind || dot(move, move) > a.half.x * a.half.x * 0.25f) continue;
            c.shape = (uint16_t)j;
            next = j + 1;
            break;
        }
        if (c.shape == kNone) continue;
        const Shape &b = to.scene->shapes[sky ? 0 : c.shape];
        for (int k = 0; k < 3; ++k) {
            Vec3 r = rows[k], turned = r;
            if (!sky) {
                // Reflections and shading do not rotate with a ball, so only textured balls are rotated
                if (a.traits().extents && !(a.isBall() && now.scene->materials[a.material].plain()))
                    turned = transposeTimes(a.frame, b.frame * r);
                if (a.half.x > 0) turned *= Vec3{1, 1, 1} * (b.half.x / a.half.x);
                c.h[k][3] = dot(turned, w.eye - a.centre) + dot(r, b.centre - v.eye);
            }
            for (int m = 0; m < 3; ++m) c.h[k][m] = dot(turned, from[m]);
        }
    }
}

void markQuads(Frame &f, Workers &workers) {
    typedef uint16_t Short8 __attribute__((vector_size(16)));
    auto at = [](const uint16_t *p) { return (Short8)_mm_loadu_si128((const __m128i *)p); };
    auto min = [](Short8 a, Short8 b) { return a < b ? a : b; };
    auto max = [](Short8 a, Short8 b) { return a < b ? b : a; };
    parallelRanges(workers, f.height, 16, [&](int first, int end, int) {
        for (int y = first; y < end; ++y) {
            const uint16_t *p = f.shapes + (ptrdiff_t)y * f.stride;
            const ptrdiff_t below = y + 1 < f.height ? f.stride : 0;
            int32_t *to = f.quads + (ptrdiff_t)y * f.stride;
            for (int x = 0; x < f.width; x += 8, p += 8) {
                Short8 a = at(p), b = at(p + 1), c = at(p + below), d = at(p + below + 1),
                       least = min(min(a, b), min(c, d));
                // Add 1, which makes kManyShapes 0
                a += 1, b += 1, c += 1, d += 1;
                Short8 most = max(max(a, b), max(c, d)), many = (Short8)(min(min(a, b), min(c, d)) == 0);
                Short8 coverage = (Short8)(most == least + 1) & (many + 2);
                _mm_storeu_si128((__m128i *)(to + x),
                                 (__m128i)__builtin_shufflevector(least, coverage, 0, 8, 1, 9, 2, 10, 3, 11));
                _mm_storeu_si128((__m128i *)(to + x + 4), (__m128i)__builtin_shufflevector(
                                                              least, coverage, 4, 12, 5, 13, 6, 14, 7, 15));
            }
        }
    });
}

Fetched fetch(const Frame &f, int shape, Float8 x, Float8 y) {
    // Interpolate by smooth steps: linear weights would blur outlines
    auto smooth = [](Float8 u) { return u * u * fmadd(u, -2.f, 3.f); };
    Float8 column = floor(x), row = floor(y), u = smooth(x - column), w = smooth(y - row);
    // The weights of the four pixels around the point
    Float8 lowerRight = u * w, upperRight = u - lowerRight, lower = w - lowerRight, upper = 1.f - u - lower;
    // Neighbouring pixels mostly map to neighbouring pixels. So instead of gathering, load once for each
    // distinct offset. (Lanes that read beyond the end of a plane read the next one.)
    const ptrdiff_t stride = f.stride;
    Int8 offset = toInt(fmadd(row, (float)f.stride, column)) - kLanes;
    Fetched found = {Rgb8{}, Int8{}};
    for (int left = 255; left;) {
        const ptrdiff_t first = offset[__builtin_ctz((unsigned)left)];
        Int8 here = offset == (int32_t)first;
        left &= ~laneBits(here);
        auto mix = [&](const float *p) {
            p += first;
            return fmadd(load(p + stride + 1), lowerRight,
                         fmadd(load(p + stride), lower, fmadd(load(p + 1), upperRight, load(p) * upper)));
        };
        found.radiance =
            select(here, Rgb8{mix(f.plane[0]), mix(f.plane[1]), mix(f.plane[2])}, found.radiance);
        // Read the shapes of the four pixels
        Int8 quad = loadInts(f.quads + first), id = quad & 0xffff;
        found.coverage |= here & ((id == shape) | (id == kManyShapes)) & (quad >> 16);
    }
    return found;
}

Fetched fetchCarried(const Frame &f, const Carry &c, Float8 px, float py, Float8 along) {
    auto row = [&](const float(&h)[4]) {
        return fmadd(along, fmadd(px, h[1], broadcast(fmadd(py, h[2], h[0]))), h[3]);
    };
    Float8 ahead = row(c.h[2]);
    Int8 valid = ahead > kAhead;
    Float8 inverse = 1.f / select(valid, ahead, 1.f);
    Float8 x = fmadd(row(c.h[0]), inverse, -0.5f), y = fmadd(row(c.h[1]), inverse, -0.5f);
    Float8 inX = clamp(x, 0.f, (float)(f.width - 1) - 0.001f),
           inY = clamp(y, 0.f, (float)(f.height - 1) - 0.001f);
    Fetched found = fetch(f, c.shape, inX, inY);
    found.coverage &= valid & (max(abs(x - inX), abs(y - inY)) < 0.5f);
    return found;
}

} // namespace odraz
