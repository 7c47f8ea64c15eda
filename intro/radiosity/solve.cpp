#include "radiosity/solve.h"

#include <initializer_list>

namespace odraz {

namespace {

struct Pair {
    Float8 a, b;
};

// Returns F B of one patch, for a block of columns.
Pair multiplyRow(const FormFactors &f, int patch, const float *values, int columns) {
    static_assert(kSolveBlock == 16);
    const Link *link = f.rows[patch].links, *end = link + f.rows[patch].count;
    Float8 a = {}, b = {}; // gcc would keep a Pair in memory
    for (; link < end; ++link) {
        const float *v = values + (size_t)link->patch * (size_t)columns;
        a = fmadd(load(v), link->share, a);
        b = fmadd(load(v + 8), link->share, b);
    }
    return {a, b};
}

void solveBlock(System &s, int block, Workers &workers, float residual, int most) {
    int columns = s.columns;
    float *values = s.indirect + (size_t)block * (size_t)s.patches;
    // Start with the light of the sources
    Float8 emitted[2] = {};
    for (int i = 0; i < s.patches; ++i)
        for (int k = 0; k < 2; ++k) {
            size_t at = (size_t)i * (size_t)columns + (size_t)(block + 8 * k);
            Float8 source = load(s.reflectance + at) * load(s.direct + at);
            emitted[k] += abs(source);
            store(values + i * kSolveBlock + 8 * k, source);
        }
    for (int sweep = 1; sweep <= most; ++sweep) {
        if (workers.aborted()) break;
        Float8 changed[2] = {};
        for (int i = 0; i < s.patches; ++i) {
            if (s.factors->rows[i].count == 0) continue;
            Pair indirect = multiplyRow(*s.factors, i, values, kSolveBlock);
            for (int k = 0; k < 2; ++k) {
                size_t at = (size_t)i * (size_t)columns + (size_t)(block + 8 * k);
                Float8 b = load(s.reflectance + at) * ((k ? indirect.b : indirect.a) + load(s.direct + at));
                float *value = values + i * kSolveBlock + 8 * k;
                changed[k] += abs(b - load(value));
                store(value, b);
            }
        }
        if (all((changed[0] <= emitted[0] * residual) & (changed[1] <= emitted[1] * residual))) break;
    }
    for (int i = 0; i < s.patches; ++i)
        for (int k = 0; k < kSolveBlock; k += 8)
            store(s.radiosity + (size_t)i * (size_t)columns + block + k, load(values + i * kSolveBlock + k));
}

} // namespace

bool makeSystem(System &s, Arena &arena, const FormFactors &factors, int patches, int unknowns) {
    int columns = (unknowns + kSolveBlock - 1) / kSolveBlock * kSolveBlock;
    s = {&factors, patches, columns, {}, {}, {}, {}};
    for (float **p : {&s.reflectance, &s.direct, &s.radiosity, &s.indirect})
        *p = arena.allocate<float>((size_t)patches * (size_t)columns);
    return !arena.full;
}

void solve(System &s, Workers &workers, float residual, int most) {
    parallelFor(workers, s.columns / kSolveBlock,
                [&](int block, int) { solveBlock(s, block * kSolveBlock, workers, residual, most); });
}

void findIndirect(const FormFactors &factors, int patches, int columns, const float *radiosity,
                  float *indirect, Workers &workers) {
    parallelRanges(workers, patches, 64, [&](int first, int end, int) {
        for (int i = first; i < end; ++i)
            for (int block = 0; block < columns; block += kSolveBlock) {
                Pair sum = multiplyRow(factors, i, radiosity + block, columns);
                float *to = indirect + (size_t)i * (size_t)columns + block;
                store(to, sum.a);
                store(to + 8, sum.b);
            }
    });
}

void fillPatches(const Model &model, const FormFactors &factors, int columns, float *values, int first,
                 int count) {
    auto valuesOf = [&](int patch) { return values + (size_t)(patch - first) * (size_t)columns; };
    for (int i = first; i < first + count; ++i) {
        if (factors.rows[i].known) continue;
        const Chart &c = model.charts[model.patches[i].chart];
        int x = (i - c.firstPatch) % c.patchesAcross, y = (i - c.firstPatch) / c.patchesAcross;
        float *to = valuesOf(i);
        int found = 0;
        for (int v = max(y - 1, 0); v <= min(y + 1, c.patchesDown - 1); ++v)
            for (int u = max(x - 1, 0); u <= min(x + 1, c.patchesAcross - 1); ++u) {
                int n = c.firstPatch + v * c.patchesAcross + u;
                if (!factors.rows[n].known) continue;
                ++found;
                factors.rows[i].links = factors.rows[n].links, factors.rows[i].count = factors.rows[n].count;
                for (int k = 0; k < columns; k += 8) {
                    Float8 mean = load(to + k), next = load(valuesOf(n) + k);
                    store(to + k, fmadd(next - mean, broadcast(1.f / (float)found), mean));
                }
            }
    }
}

} // namespace odraz
