#include "radiosity/elements.h"

#include "base/maths.h"
#include "base/random.h"

namespace odraz {

namespace {

uint32_t hashOf(int chart, int x, int y) {
    return pcg((uint32_t)chart ^ pcg((uint32_t)x * 0x9e3779b1u ^ (uint32_t)y));
}

// Makes a texel fresh, for cells as small as those of `level`.
void markFresh(Model &m, int number, int level) {
    Texel &t = m.texels[number];
    if (t.level < level) t.level = (uint8_t)level;
    if (t.fresh) return;
    t.fresh = true;
    m.fresh[m.freshCount++] = number;
}

int findOrAdd(Model &m, int chart, int x, int y, int level) {
    int number = findTexel(m, chart, x, y);
    if (number < 0) {
        number = m.texelCount++;
        m.texels[number] = {chart, x, y, (uint8_t)level, 0, false, false};
        uint32_t i = hashOf(chart, x, y);
        while (m.table[i & m.tableMask]) ++i;
        m.table[i & m.tableMask] = number + 1;
        markFresh(m, number, level);
    } else if (m.texels[number].level < level) {
        markFresh(m, number, level);
    }
    return number;
}

// Whether a cell on a facet is hidden at some of the places that were sampled, or, if it is undivided, at all
// of them: the part of it that is visible may be small.
bool partlyHidden(const Model &m, const Cell &cell) {
    int quarters = 0;
    for (int k = 0; k < 4; ++k) quarters += m.quarterVisible(cell, k);
    if (quarters == 4 || (quarters == 0 && cell.level > 0)) return false;
    const Chart &c = m.charts[cell.chart];
    const Texel &low = m.texels[cell.corner[0]], &high = m.texels[cell.corner[3]];
    float du = c.width / (float)(c.across * kSteps), dv = c.height / (float)(c.down * kSteps);
    for (int i = c.firstFacet; i < c.firstFacet + c.facetsCount; ++i) {
        const Facet &f = m.facets[i];
        if (f.triangle()) continue; // a triangle leaves half of its rectangle empty anyway
        float u0 = min(min(f.u[0], f.u[1]), f.u[2]), u1 = max(max(f.u[0], f.u[1]), f.u[2]),
              v0 = min(min(f.v[0], f.v[1]), f.v[2]), v1 = max(max(f.v[0], f.v[1]), f.v[2]);
        if (u0 < (float)high.x * du && u1 > (float)low.x * du && v0 < (float)high.y * dv &&
            v1 > (float)low.y * dv)
            return true;
    }
    return false;
}

} // namespace

int findTexel(const Model &m, int chart, int x, int y) {
    const Chart &c = m.charts[chart];
    if ((x | y) % kSteps == 0) return c.texel(x / kSteps, y / kSteps);
    for (uint32_t i = hashOf(chart, x, y);; ++i) {
        int entry = m.table[i & m.tableMask];
        if (entry == 0) return -1;
        const Texel &t = m.texels[entry - 1];
        if (t.chart == chart && t.x == x && t.y == y) return entry - 1;
    }
}

void settleFresh(Model &m) {
    for (int i = 0; i < m.freshCount; ++i) m.texels[m.fresh[i]].fresh = false;
    m.freshCount = 0;
}

void split(Model &m, int index) {
    Cell cell = m.cells[index];
    int chart = cell.chart, level = cell.level + 1;
    Texel low = m.texels[cell.corner[0]], high = m.texels[cell.corner[3]];
    int half = (high.x - low.x) / 2, grid[9];
    for (int k = 0; k < 9; ++k)
        grid[k] = findOrAdd(m, chart, low.x + k % 3 * half, low.y + k / 3 * half, level);
    m.cells[index].corner[0] = ~m.cellCount;
    for (int k = 0; k < 4; ++k) {
        const int *g = grid + (k & 1) + (k & 2) / 2 * 3;
        m.cells[m.cellCount++] = {{g[0], g[1], g[3], g[4]}, cell.patch, chart, cell.area * 0.25f, level};
    }
}

bool measure(const Model &m, const float *plane, float contrast, Measure &to) {
    double sum = 0;
    int seen = 0;
    for (int t = 0; t < m.texelCount; ++t)
        if (m.texels[t].visible) sum += (double)(plane[t] * plane[t]), ++seen;
    to = {plane, contrast * sqrt((float)(sum / max(seen, 1)))};
    return sum > 0;
}

void refine(Model &m, int level, const Measure *measures, int count, float contrast) {
    int cells = m.cellCount;
    for (int i = 0; i < cells; ++i) {
        const Cell &cell = m.cells[i];
        if (cell.divided() || cell.level != level) continue;
        bool divide = partlyHidden(m, cell);
        for (int k = 0; k < count && !divide; ++k) {
            float low = kInfinity, high = -kInfinity;
            for (int corner : cell.corner) {
                if (!m.texels[corner].visible) continue;
                low = min(low, measures[k].plane[corner]), high = max(high, measures[k].plane[corner]);
            }
            divide = high - low > fmadd(contrast, high + low, measures[k].least);
        }
        if (divide) split(m, i);
    }
}

} // namespace odraz
