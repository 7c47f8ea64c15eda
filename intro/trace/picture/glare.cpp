#include "trace/picture/glare.h"

#include "base/maths.h"

namespace odraz {

namespace {

constexpr int kMargin = 8; // floats before the first row

int strideFor(int width) { return ((width + 7) & ~7) + 8; }

// Repeats the first value of a row before it, and the last one after it.
void repeatEnds(const Glare::Level &l, float *row) {
    for (int x = l.width; x < l.stride - 1; ++x) row[x] = row[l.width - 1];
    row[-1] = row[0];
}

// Fills row y of a level with means of two by two values of the next finer level, which has the given stride.
void halve(Glare::Level &to, int y, const float *const (&plane)[3], int width, int height, int stride) {
    for (int c = 0; c < 3; ++c) {
        const float *a = plane[c] + (ptrdiff_t)(2 * y) * stride, *b = 2 * y + 1 < height ? a + stride : a;
        float *out = to.plane[c] + (ptrdiff_t)y * to.stride;
        for (int x = 0; x < width / 2; x += 8) {
            Float8 low = load(a + 2 * x) + load(b + 2 * x), high = load(a + 2 * x + 8) + load(b + 2 * x + 8);
            __m256d pairs = _mm256_castps_pd(_mm256_hadd_ps(low, high));
            store(out + x, (Float8)_mm256_castpd_ps(_mm256_permute4x64_pd(pairs, 0xd8)) * 0.25f);
        }
        if (width & 1) out[to.width - 1] = (a[width - 1] + b[width - 1]) * 0.5f;
        repeatEnds(to, out);
    }
}

// Mixes row y of a level (weight `share`) with the next coarser level, interpolated (weight 1 - share).
void addWider(Glare::Level &to, int y, const Glare::Level &from, float share) {
    int near = y >> 1, far = clamp(y & 1 ? near + 1 : near - 1, 0, from.height - 1);
    for (int c = 0; c < 3; ++c) {
        const float *a = from.plane[c] + (ptrdiff_t)near * from.stride,
                    *b = from.plane[c] + (ptrdiff_t)far * from.stride;
        float *out = to.plane[c] + (ptrdiff_t)y * to.stride;
        for (int x = 0; x < to.width; x += 16) {
            auto column = [&](int i) {
                Float8 v = load(a + i);
                return fmadd(load(b + i) - v, 0.25f, v);
            };
            Float8 middle = column(x / 2) * 0.75f, even = fmadd(column(x / 2 - 1), 0.25f, middle),
                   odd = fmadd(column(x / 2 + 1), 0.25f, middle);
            __m256 low = _mm256_unpacklo_ps(even, odd), high = _mm256_unpackhi_ps(even, odd);
            auto put = [&](int i, Float8 v) {
                if (i < to.width) store(out + i, fmadd(load(out + i) - v, share, v));
            };
            put(x, _mm256_permute2f128_ps(low, high, 0x20));
            put(x + 8, _mm256_permute2f128_ps(low, high, 0x31));
        }
        repeatEnds(to, out);
    }
}

// Divides the memory among the levels for frames of a given size.
void layOut(Glare &glare, int width, int height) {
    float *next = glare.memory + kMargin;
    for (Glare::Level &l : glare.level) {
        width = (width + 1) / 2, height = (height + 1) / 2;
        l = {width, height, strideFor(width), {}};
        for (float *&plane : l.plane) plane = next, next += (ptrdiff_t)l.stride * height + 2 * kMargin;
    }
}

} // namespace

size_t glareBytes(int width, int height) {
    size_t floats = 0;
    for (int i = 0; i < Glare::kLevels; ++i) {
        width = (width + 1) / 2, height = (height + 1) / 2;
        floats += ((size_t)strideFor(width) * (size_t)height + 2 * kMargin) * 3;
    }
    return floats * sizeof(float) + 64;
}

bool makeGlare(Glare &glare, Arena &arena, int width, int height) {
    glare.memory = arena.allocate<float>(glareBytes(width, height) / sizeof(float));
    return !arena.full;
}

void spreadGlare(Glare &glare, const Frame &frame, Workers &workers) {
    const float *plane[3] = {frame.plane[0], frame.plane[1], frame.plane[2]};
    int width = frame.width, height = frame.height, stride = frame.stride;
    layOut(glare, width, height);
    for (Glare::Level &l : glare.level) {
        parallelRanges(workers, l.height, 32, [&](int first, int end, int) {
            for (int y = first; y < end; ++y) halve(l, y, plane, width, height, stride);
        });
        for (int c = 0; c < 3; ++c) plane[c] = l.plane[c];
        width = l.width, height = l.height, stride = l.stride;
    }
    // Sum the levels from the coarsest to level 1, so that every circle gets the same amount of light
    for (int i = Glare::kLevels - 2; i > 0; --i)
        parallelRanges(workers, glare.level[i].height, 32, [&](int first, int end, int) {
            for (int y = first; y < end; ++y)
                addWider(glare.level[i], y, glare.level[i + 1], 1 / (float)(Glare::kLevels - i));
        });
}

} // namespace odraz
