#include "radiosity/ties.h"

namespace odraz {

void tie(Model &m) {
    // Add ties outwards from the known texels, ring by ring. A texel with several ties gets the mean
    auto unknown = [&](int t) { return !m.texels[t].visible && !m.texels[t].filled; };
    m.tieCount = 0;
    for (int begin = -1; begin != m.tieCount;) {
        begin = m.tieCount;
        for (int i = 0; i < m.cellCount; ++i) {
            const Cell &cell = m.cells[i];
            for (int a : cell.corner)
                for (int b : cell.corner)
                    if (unknown(a) && !unknown(b))
                        m.ties[m.tieCount++] = {a, b, 1.f / (float)++m.texels[a].ties};
        }
        for (int i = begin; i < m.tieCount; ++i) m.texels[m.ties[i].texel].filled = true;
    }
}

void applyTies(const Model &m, float *plane) {
    for (int i = 0; i < m.tieCount; ++i) {
        const Tie &t = m.ties[i];
        plane[t.texel] = lerp(plane[t.texel], plane[t.towards], t.share);
    }
}

} // namespace odraz
