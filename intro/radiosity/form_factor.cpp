#include "radiosity/form_factor.h"

#include "base/maths.h"

namespace odraz {

// A pixel's form factor integrates 1 / (pi (1 + a^2 + b^2)^2) over the pixel; on a side face, b times that.
// Each pixel is divided into squares, which are integrated by Gauss's rule with 2 x 2 points.
void deltaFormFactors(int px, float *delta) {
    int squares = 64 / px + 1; // along a pixel's side; more than 64 along a face's
    float size = 2 / (float)(px * squares);
    auto at = [&](int pixel, int k) {
        return ((float)(pixel * squares + k / 2) + (k % 2 ? 0.78867513f : 0.21132487f)) * size;
    };
    for (int y = 0; y < 3 * px; ++y)
        for (int x = 0; x < px; ++x) {
            bool top = y < px;
            float sum = 0;
            for (int k = 0; k < 2 * squares; ++k)
                for (int l = 0; l < 2 * squares; ++l) {
                    float a = at(x, k) - 1, b = top ? at(y, l) - 1 : at((y - px) % (px / 2), l);
                    float square = 1 + a * a + b * b;
                    sum += (top ? 1 : b) / (square * square);
                }
            *delta++ = sum * (size * size / (4 * kPi));
        }
}

void accumulateFormFactors(int px, const float *delta, float *sums) {
    for (int y = 0; y < 3 * px; ++y) {
        double sum = 0;
        *sums++ = 0;
        for (int x = 0; x < px; ++x) *sums++ = (float)(sum += (double)*delta++);
    }
}

float sumHemicube(const Hemicubes &h, int index, const float *sums, float *row) {
    const uint32_t *ids = hemicubeIds(h, index);
    int px = h.px, stride = hemicubeStride(h);
    float dark = 0;
    for (int y = 0; y < 3 * px; ++y, ids += stride, sums += px + 1) {
        int start = 0;
        auto end = [&](int x) { // ends a run of equal ids
            uint32_t id = ids[start];
            if (id == kNothing) {
                // Count a crack as one of its neighbours, if there is something on both sides of it
                for (int k = start; k < x; ++k) {
                    uint32_t left = k > 0 ? ids[k - 1] : 0, right = k + 1 < px ? ids[k + 1] : 0;
                    uint32_t above = y > 0 ? ids[k - stride] : 0,
                             below = y + 1 < 3 * px ? ids[k + stride] : 0;
                    uint32_t seen = left && right ? left : above && below ? above : kBackSide;
                    float share = sums[k + 1] - sums[k];
                    if (seen == kBackSide)
                        dark += share;
                    else
                        row[seen - 1] += share;
                }
            } else if (id == kBackSide) {
                dark += sums[x] - sums[start];
            } else {
                row[id - 1] += sums[x] - sums[start];
            }
            start = x;
        };
        // Find the ends of runs, eight pixels at a time
        int x = 1;
        for (; x + 8 <= px; x += 8)
            for (int ends = laneBits(loadInts((const int *)ids + x - 1) != loadInts((const int *)ids + x));
                 ends; ends &= ends - 1)
                end(x + __builtin_ctz((unsigned)ends));
        for (; x < px; ++x)
            if (ids[x] != ids[x - 1]) end(x);
        end(px);
    }
    return dark;
}

bool findFormFactors(const HemicubeMethod &method, Hemicubes &h, const Model &model, Workers &workers,
                     Arena &arena, FormFactors &factors, const Progress &progress) {
    int count = model.patchCount, rowFloats = (count + 7) & ~7;
    float *delta = arena.allocate<float>((size_t)(3 * h.px * h.px));
    float *sums = arena.allocate<float>((size_t)(3 * h.px * (h.px + 1)));
    float *rows = arena.allocate<float>((size_t)rowFloats * (size_t)h.batch);
    factors.rows = arena.allocate<FormFactorRow>((size_t)count);
    factors.used = 0;
    if (arena.full) return false;
    deltaFormFactors(h.px, delta);
    accumulateFormFactors(h.px, delta, sums);

    for (int i = 0; i < count;) {
        // Fill an atlas
        Eye eyes[kHemicubeBatch];
        int patchOf[kHemicubeBatch], batch = 0;
        for (; i < count && batch < h.batch; ++i) {
            const Patch &p = model.patches[i];
            if (p.share == 0 || maxComponent(p.reflects) <= 0) continue;
            eyes[batch] = hemicubeEye(p.p, p.n, (uint32_t)i);
            patchOf[batch++] = i;
        }
        if (!method.fill(h, model, eyes, batch)) return false;
        parallelFor(workers, batch, [&](int k, int) {
            float *row = rows + (size_t)k * (size_t)rowFloats;
            for (int j = 0; j < rowFloats; ++j) row[j] = 0;
            sumHemicube(h, k, sums, row);
        });
        if (workers.aborted()) return false;
        // Store the form factors above zero
        size_t before = factors.used;
        for (int k = 0; k < batch; ++k) {
            const float *row = rows + (size_t)k * (size_t)rowFloats;
            if (row[patchOf[k]] > 0) return false; // no patch sees itself: the ids are wrong
            FormFactorRow &to = factors.rows[patchOf[k]];
            Link *link = factors.links + factors.used, *end = factors.links + factors.capacity;
            to.links = link;
            for (int first = 0; first < rowFloats; first += 8)
                for (int lanes = laneBits(load(row + first) > 0.f); lanes; lanes &= lanes - 1) {
                    int j = first + __builtin_ctz(lanes);
                    if (link == end) {
                        arena.full = true;
                        return false;
                    }
                    *link++ = {(uint32_t)j, row[j]};
                }
            to.count = (int)(link - to.links);
            to.known = true;
            factors.used = (size_t)(link - factors.links);
        }
        if (batch && factors.used == before) return false; // no patch sees another: nothing was drawn
        progress((float)i / (float)count);
    }
    return true;
}

} // namespace odraz
