#include "radiosity/solve.h"

#include <initializer_list>

namespace odraz {

namespace {

struct Pair {
    Float8 a, b;
};

// F B of one patch, for a block of columns. Links are summed four at a time, in four sums: the additions need
// not wait for each other.
Pair gatherRow(const FormFactors &f, int patch, const float *values, int columns) {
    static_assert(kSolveBlock == 16);
    const Link *link = f.links + f.start[patch], *end = f.links + f.start[patch + 1];
    Pair sum[4] = {};
    auto add = [&](Pair &s, const Link &l) {
        const float *v = values + (size_t)l.patch * (size_t)columns;
        Float8 share = broadcast(l.share);
        s.a = fmadd(share, load(v), s.a);
        s.b = fmadd(share, load(v + 8), s.b);
    };
    for (; link + 4 <= end; link += 4)
        for (int i = 0; i < 4; ++i) add(sum[i], link[i]);
    for (; link < end; ++link) add(sum[0], *link);
    return {(sum[0].a + sum[1].a) + (sum[2].a + sum[3].a), (sum[0].b + sum[1].b) + (sum[2].b + sum[3].b)};
}

int solveBlock(System &s, int block, Workers &workers, float residual, int most) {
    int columns = s.columns;
    // What the sources put in
    Float8 put[2] = {};
    for (int i = 0; i < s.patches; ++i)
        for (int k = 0; k < 2; ++k) {
            size_t at = (size_t)i * (size_t)columns + (size_t)(block + 8 * k);
            Float8 source = load(s.reflectance + at) * load(s.direct + at);
            put[k] += source;
            store(s.radiosity + at, source);
        }
    for (int sweep = 1; sweep <= most; ++sweep) {
        if (workers.aborted()) return most;
        Float8 changed[2] = {};
        for (int i = 0; i < s.patches; ++i) {
            if (s.factors->start[i] == s.factors->start[i + 1]) continue;
            Pair gathered = gatherRow(*s.factors, i, s.radiosity + block, columns);
            for (int k = 0; k < 2; ++k) {
                size_t at = (size_t)i * (size_t)columns + (size_t)(block + 8 * k);
                Float8 b = load(s.reflectance + at) * ((k ? gathered.b : gathered.a) + load(s.direct + at));
                changed[k] += abs(b - load(s.radiosity + at));
                store(s.radiosity + at, b);
            }
        }
        if (all((changed[0] <= put[0] * residual) & (changed[1] <= put[1] * residual))) return sweep;
    }
    return most;
}

} // namespace

bool makeSystem(System &s, Arena &arena, const FormFactors &factors, int patches, int unknowns) {
    int columns = (unknowns + kSolveBlock - 1) / kSolveBlock * kSolveBlock;
    s = {&factors, patches, columns, {}, {}, {}};
    for (float **p : {&s.reflectance, &s.direct, &s.radiosity})
        if (!(*p = arena.take<float>((size_t)patches * (size_t)columns))) return false;
    return true;
}

int solve(System &s, Workers &workers, float residual, int most) {
    int sweeps[64] = {}, worst = 0, blocks = s.columns / kSolveBlock;
    parallelFor(workers, blocks, [&](int block, int) {
        sweeps[block] = solveBlock(s, block * kSolveBlock, workers, residual, most);
    });
    for (int i = 0; i < blocks; ++i) worst = max(worst, sweeps[i]);
    return worst;
}

void gather(const FormFactors &factors, int patches, int columns, const float *radiosity, float *gathered,
            Workers &workers) {
    static constexpr int kRows = 64;
    parallelFor(workers, (patches + kRows - 1) / kRows, [&](int piece, int) {
        for (int i = piece * kRows; i < min(piece * kRows + kRows, patches); ++i)
            for (int block = 0; block < columns; block += kSolveBlock) {
                Pair sum = gatherRow(factors, i, radiosity + block, columns);
                float *to = gathered + (size_t)i * (size_t)columns + block;
                store(to, sum.a);
                store(to + 8, sum.b);
            }
    });
}

void addToElements(const Model &model, const float *values, int stride, float *plane) {
    for (int index = 0; index < model.chartCount; ++index) {
        const Chart &c = model.charts[index];
        int across = c.patchesAcross(), down = c.patchesDown();
        // Patches that cannot be seen take what those beside them have
        auto value = [&](int i, int j) {
            int k = c.firstPatch + j * across + i;
            if (model.patches[k].share > 0) return values[(size_t)k * (size_t)stride];
            float sum = 0;
            int count = 0;
            for (int y = max(j - 1, 0); y <= min(j + 1, down - 1); ++y)
                for (int x = max(i - 1, 0); x <= min(i + 1, across - 1); ++x) {
                    int n = c.firstPatch + y * across + x;
                    if (model.patches[n].share == 0) continue;
                    sum += values[(size_t)n * (size_t)stride];
                    ++count;
                }
            return count ? sum / (float)count : 0;
        };
        // Between which two middles an element lies, and where
        auto place = [](int element, int size, int patches, int &first) {
            float x = ((float)element + 0.5f) / (float)size - 0.5f;
            first = clamp((int)(x + 1) - 1, 0, max(patches - 2, 0));
            return patches > 1 ? x - (float)first : 0.f;
        };
        for (int j = 0; j < c.down; ++j)
            for (int i = 0; i < c.across; ++i) {
                int x, y;
                float fx = place(i, c.patchAcross, across, x), fy = place(j, c.patchDown, down, y);
                int x1 = min(x + 1, across - 1), y1 = min(y + 1, down - 1);
                float a = value(x, y), b = value(x1, y), d = value(x, y1), e = value(x1, y1);
                float v = lerp(lerp(a, b, fx), lerp(d, e, fx), fy);
                // Going straight on outside must not run below half of the least
                plane[c.texel(i, j)] += max(v, min(min(a, b), min(d, e)) * 0.5f);
            }
    }
}

void fillRings(const Model &model, float *plane) {
    for (int index = 0; index < model.chartCount; ++index) {
        const Chart &c = model.charts[index];
        auto copy = [&](int i, int j) {
            plane[c.texel(i, j)] = plane[c.texel(clamp(i, 0, c.across - 1), clamp(j, 0, c.down - 1))];
        };
        for (int i = -1; i <= c.across; ++i) copy(i, -1), copy(i, c.down);
        for (int j = 0; j < c.down; ++j) copy(-1, j), copy(c.across, j);
    }
}

void closeGaps(const Model &model, float *plane) {
    for (int index = 0; index < model.chartCount; ++index) {
        const Chart &c = model.charts[index];
        // Outwards from what is known, ring by ring; -1 marks what is not known yet
        int unknown = 0, before = -1;
        for (int j = 0; j < c.down; ++j)
            for (int i = 0; i < c.across; ++i)
                if (!model.visible[c.texel(i, j)]) {
                    plane[c.texel(i, j)] = -1;
                    ++unknown;
                }
        while (unknown && unknown != before) {
            before = unknown;
            for (int j = 0; j < c.down; ++j)
                for (int i = 0; i < c.across; ++i) {
                    float &v = plane[c.texel(i, j)];
                    if (v != -1) continue;
                    float sum = 0;
                    int count = 0;
                    auto look = [&](int x, int y) {
                        if (x < 0 || y < 0 || x >= c.across || y >= c.down) return;
                        float n = plane[c.texel(x, y)];
                        if (n < 0) return;
                        sum += n;
                        ++count;
                    };
                    look(i - 1, j), look(i + 1, j), look(i, j - 1), look(i, j + 1);
                    if (count) v = -2 - sum / (float)count;
                }
            // What was found in this round becomes known after it
            for (int j = 0; j < c.down; ++j)
                for (int i = 0; i < c.across; ++i) {
                    float &v = plane[c.texel(i, j)];
                    if (v > -2) continue;
                    v = -2 - v;
                    --unknown;
                }
        }
        for (int i = c.firstTexel; i < c.firstTexel + c.texels(); ++i) plane[i] = max(plane[i], 0.f);
    }
    fillRings(model, plane);
}

float meanOfPatch(const Model &model, int patch, const float *plane) {
    const Patch &p = model.patches[patch];
    const Chart &c = model.charts[p.chart];
    float sum = 0;
    int places = 0;
    for (int j = p.j; j < p.j + c.patchDown; ++j)
        for (int i = p.i; i < p.i + c.patchAcross; ++i) {
            int seen = __builtin_popcount(model.visible[c.texel(i, j)]);
            sum += plane[c.texel(i, j)] * (float)seen;
            places += seen;
        }
    return places ? sum / (float)places : 0;
}

} // namespace odraz
