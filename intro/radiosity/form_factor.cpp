#include "radiosity/form_factor.h"

namespace odraz {

namespace {

double root(double x) { return __builtin_sqrt(x); }

// Halving the angle three times leaves |x| < 0.2 for a series.
double arcTangent(double x) {
    for (int i = 0; i < 3; ++i) x /= 1 + root(1 + x * x);
    double square = x * x, sum = 0;
    for (int k = 23; k > 0; k -= 2) sum = 1.0 / k - square * sum;
    return 8 * x * sum;
}

constexpr double kTwoPi = 6.283185307179586;

// Integrals of the hemicube's kernels, 1 / (pi (1 + a^2 + b^2)^2) on the top face and b times that on a side,
// over [0, a] x [0, b] up to what cancels in the differences below.
double topIntegral(double a, double b) {
    double ra = root(1 + a * a), rb = root(1 + b * b);
    return (a / ra * arcTangent(b / ra) + b / rb * arcTangent(a / rb)) / kTwoPi;
}
double sideIntegral(double a, double b) {
    double rb = root(1 + b * b);
    return -arcTangent(a / rb) / (kTwoPi * rb);
}

} // namespace

void deltaFormFactors(int px, float *delta) {
    for (int row = 0; row < px + px / 2; ++row)
        for (int column = 0; column < px; ++column) {
            bool top = row < px;
            auto *integral = top ? topIntegral : sideIntegral;
            double size = 2.0 / px, a = column * size - 1, b = top ? row * size - 1 : (row - px) * size;
            double d =
                integral(a + size, b + size) - integral(a, b + size) - integral(a + size, b) + integral(a, b);
            for (int side = 0; side < (top ? 1 : 4); ++side)
                delta[(row + side * (px / 2)) * px + column] = (float)d;
        }
}

float sumHemicube(const Hemicubes &h, int index, const float *delta, float *row) {
    const uint32_t *ids = hemicubeIds(h, index);
    int px = h.px, stride = hemicubeStride(h);
    // Pixels of one number in a line are summed first: fewer roundings, and fewer additions far apart
    double dark = 0;
    for (int y = 0; y < 3 * px; ++y, ids += stride, delta += px)
        for (int x = 0; x < px;) {
            uint32_t id = ids[x];
            double run = (double)delta[x];
            int start = x;
            while (++x < px && ids[x] == id) run += (double)delta[x];
            bool crack =
                id == kNothing && x == start + 1 && start > 0 && x < px && ids[start - 1] != kNothing;
            if (crack) id = ids[start - 1];
            if (id == kNothing || id == kBackSide)
                dark += run;
            else
                row[id - 1] += (float)run;
        }
    return (float)dark;
}

bool findFormFactors(Hemicubes &h, const Model &model, const bool *reflects, Workers &workers, Arena &arena,
                     FormFactors &factors, const Progress &progress) {
    int count = model.patchCount, rowFloats = (count + 7) & ~7;
    float *delta = arena.take<float>((size_t)(3 * h.px * h.px));
    float *rows = arena.take<float>((size_t)rowFloats * kHemicubeBatch);
    factors.start = arena.take<size_t>((size_t)count + 1);
    if (!delta || !rows || !factors.start) return false;
    deltaFormFactors(h.px, delta);
    auto lit = [&](int i) {
        const Chart &c = model.charts[model.patches[i].chart];
        return !c.open && reflects[c.material];
    };

    size_t links = 0;
    int next = 0;
    for (int i = 0; i < count;) {
        // Fill an atlas
        Eye eyes[kHemicubeBatch];
        int patchOf[kHemicubeBatch], batch = 0;
        for (; i < count && batch < kHemicubeBatch; ++i) {
            const Patch &p = model.patches[i];
            if (p.share == 0 || !lit(i)) continue;
            patchOf[batch] = i;
            eyes[batch++] = hemicubeEye(p.p, model.charts[p.chart].n, (uint32_t)i);
        }
        drawHemicubes(h, model, eyes, batch);
        parallelFor(workers, batch, [&](int k, int) {
            float *row = rows + (size_t)k * (size_t)rowFloats;
            for (int j = 0; j < rowFloats; ++j) row[j] = 0;
            sumHemicube(h, k, delta, row);
        });
        if (workers.aborted()) return false;
        // Keep what is not zero
        for (int k = 0; k < batch; ++k) {
            const float *row = rows + (size_t)k * (size_t)rowFloats;
            for (; next <= patchOf[k]; ++next) factors.start[next] = links;
            for (int first = 0; first < rowFloats; first += 8)
                for (int lanes = laneBits(load(row + first) > 0.f); lanes; lanes &= lanes - 1) {
                    int j = first + __builtin_ctz(lanes);
                    if (!lit(j)) continue;
                    if (links == factors.capacity) return false;
                    factors.links[links++] = {(uint32_t)j, row[j]};
                }
        }
        progress((float)i / (float)count);
    }
    for (; next <= count; ++next) factors.start[next] = links;
    return true;
}

} // namespace odraz
