#include "radiosity/spread.h"

namespace odraz {

void meansOfPatches(const Model &m, const float *plane, float *mean, int stride) {
    for (int i = 0; i < m.patchCount; ++i) mean[(size_t)i * (size_t)stride] = 0;
    for (int i = 0; i < m.cellCount; ++i) {
        const Cell &cell = m.cells[i];
        float sum = 0;
        for (int k = 0; k < 4; ++k)
            if (m.quarterVisible(cell, k)) sum += plane[cell.corner[k]];
        mean[(size_t)cell.patch * (size_t)stride] += sum * cell.area * 0.25f;
    }
    for (int i = 0; i < m.patchCount; ++i)
        if (m.patches[i].area > 0) mean[(size_t)i * (size_t)stride] /= m.patches[i].area;
}

void addToTexels(const Model &m, const float *values, int columns, float *const *planes, int count,
                 Workers &workers, int coupled) {
    parallelRanges(workers, m.texelCount, 1024, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const Texel &t = m.texels[i];
            const Chart &c = m.charts[t.chart];
            // Find the two centres around the texel, and its position between them
            auto locate = [](int x, int size, int patches, int &first, int &next) {
                float at = (float)x / (float)size - 0.5f;
                first = clamp((int)(at + 1) - 1, 0, max(patches - 2, 0));
                next = min(first + 1, patches - 1);
                return broadcast(patches > 1 ? at - (float)first : 0.f);
            };
            int across = c.patchesAcross, x0, x1, y0, y1;
            Float8 x = locate(t.x, c.patchAcross(), across, x0, x1),
                   y = locate(t.y, c.patchDown(), c.patchesDown, y0, y1);
            auto from = [&](int x, int y) {
                return values + (size_t)(c.firstPatch + y * across + x) * (size_t)columns;
            };
            const float *at[4] = {from(x0, y0), from(x1, y0), from(x0, y1), from(x1, y1)};
            float share = 1;
            for (int k = 0; k < count; k += 8) {
                Float8 a = load(at[0] + k), b = load(at[1] + k), d = load(at[2] + k), e = load(at[3] + k);
                auto between = [&](Float8 x, Float8 y) {
                    Float8 upper = fmadd(b - a, x, a), lower = fmadd(e - d, x, d);
                    return fmadd(lower - upper, y, upper);
                };
                Float8 v = between(x, y), least = min(min(a, b), min(d, e)) * 0.5f;
                if (k < coupled) {
                    Float8 inside = between(saturate(x), saturate(y));
                    if (k == 0 && v[0] < least[0]) share = (inside[0] - least[0]) / (inside[0] - v[0]);
                    least = select(kLanes < coupled - k, inside + (v - inside) * share, least);
                    v = select(kLanes < coupled - k, least, v);
                }
                v = max(v, least);
                for (int j = 0; j < min(count - k, 8); ++j) planes[k + j][i] += v[j];
            }
        }
    });
}

} // namespace odraz
