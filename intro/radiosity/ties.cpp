#include "radiosity/ties.h"

namespace odraz {

namespace {

float visibleArea(const Model &m, const Cell &cell) {
    int quarters = 0;
    for (int k = 0; k < 4; ++k) quarters += m.quarterVisible(cell, k);
    return cell.area * 0.25f * (float)quarters;
}

// A texel that hangs between two corners of a cell gets the mean of those corners.
void tieBetween(Model &m, int a, int b) {
    const Texel &p = m.texels[a], &q = m.texels[b];
    int x = p.x + q.x, y = p.y + q.y;
    if ((x | y) & 1) return; // no texel lies between the finest ones
    int middle = findTexel(m, p.chart, x / 2, y / 2);
    if (middle < 0) return;
    m.ties[m.tieCount++] = {middle, a, 1};
    m.ties[m.tieCount++] = {middle, b, 0.5f};
    tieBetween(m, a, middle);
    tieBetween(m, middle, b);
}

} // namespace

void tie(Model &m) {
    // Hidden texels: outwards from what is known, ring by ring
    auto unknown = [&](int t) { return !m.texels[t].visible && !m.texels[t].filled; };
    for (int begin = -1; begin != m.tieCount;) {
        begin = m.tieCount;
        for (int i = 0; i < m.cellCount; ++i) {
            const Cell &cell = m.cells[i];
            if (cell.divided()) continue;
            for (int a : cell.corner)
                for (int b : cell.corner)
                    if (unknown(a) && !unknown(b)) m.ties[m.tieCount++] = {a, b, 1};
        }
        // A texel with several ties gets the mean of all
        for (int i = begin; i < m.tieCount; ++i) {
            Texel &t = m.texels[m.ties[i].texel];
            if (!t.filled) t.level = 0; // from now on it counts the ties
            t.filled = true;
            ++t.level;
        }
        for (int i = m.tieCount - 1; i >= begin; --i) {
            Texel &t = m.texels[m.ties[i].texel];
            m.ties[i].share = 1.f / (float)t.level--;
        }
    }
    for (int i = 0; i < m.cellCount; ++i)
        if (!m.cells[i].divided()) m.patches[m.cells[i].patch].area += visibleArea(m, m.cells[i]);
    // Texels that hang
    for (int i = 0; kForTools && i < m.cellCount; ++i) {
        const int *c = m.cells[i].corner;
        if (c[0] < 0) continue;
        tieBetween(m, c[0], c[1]);
        tieBetween(m, c[2], c[3]);
        tieBetween(m, c[0], c[2]);
        tieBetween(m, c[1], c[3]);
    }
}

void settle(const Model &m, float *plane) {
    for (int i = 0; i < m.tieCount; ++i) {
        const Tie &t = m.ties[i];
        plane[t.texel] = lerp(plane[t.texel], plane[t.towards], t.share);
    }
}

} // namespace odraz
