#include "radiosity/elements.h"

#include "base/maths.h"
#include "base/random.h"
#include "trace/rays/intersect.h"

namespace odraz {

namespace {

void put(Vec3x8 &to, int k, Vec3 v) { to.x[k] = v.x, to.y[k] = v.y, to.z[k] = v.z; }

// Whether the nearest thing that points see in a direction is a back: then they lie inside a solid. Fronts
// alone stop a ray of the tracer, both sides stop light.
Int8 seesBack(const Scene &scene, Vec3x8 p, Vec3x8 d, Int8 active) {
    Hit8 front = intersect(scene, {p, d}, active);
    Float8 open = transmittance(scene, {p, d}, min(front.t, kFar) * 0.9999f, active, broadcast(-1)).y;
    return active & (open < 0.5f);
}

// A place inside a solid that stands against a wall may look along it and see the wall: so in several
// directions; and from two sides, so that what touches a solid's edge counts as inside. In a model whose
// backs may be seen it is inside where it sees nothing else to all sides; upwards it may, for tubes have no
// lids.
Int8 insideSolid(const Model &model, const Scene &scene, const Texels8 &t, const Places8 &places) {
    Int8 some = {}, all = places.active;
    for (int i = 0; i < (model.solid ? 4 : any(all) ? 8 : 0); ++i) {
        float side = i & 1 ? -0.08f : 0.08f, slant = i & 2 ? (model.solid ? 0.004f : 0.5f) : 1;
        float a = side * 10 * slant, b = side * 8 * slant;
        Vec3x8 d = normalize(t.n + t.u * broadcast(i < 4 ? a : -b) + t.v * broadcast(i < 4 ? b : a));
        Int8 sees = seesBack(scene, t.at(places.x + side, places.y + side), d, places.active);
        some |= sees;
        all &= sees;
    }
    return model.solid ? some : all;
}

// Whether a place lies on a facet of its chart.
bool onFacet(const Model &model, const Chart &c, float u, float v) {
    float slack = (c.width + c.height) * 1e-6f;
    for (int i = c.firstFacet; i < c.firstFacet + c.facetsCount; ++i) {
        const Facet &f = model.facets[i];
        bool inside = true;
        for (int k = 0; k < 4; ++k) {
            int next = (k + 1) & 3;
            float du = f.u[next] - f.u[k], dv = f.v[next] - f.v[k];
            inside &= du * (v - f.v[k]) - dv * (u - f.u[k]) >= -slack * (abs(du) + abs(dv));
        }
        if (inside) return true;
    }
    return false;
}

uint32_t hashOf(int chart, int x, int y) {
    return pcg((uint32_t)chart ^ pcg((uint32_t)x * 0x9e3779b1u ^ (uint32_t)y));
}

// The texel at a place, -1 where there is none.
int find(const Model &m, int chart, int x, int y) {
    const Chart &c = m.charts[chart];
    if ((x | y) % kSteps == 0) return c.texel(x / kSteps, y / kSteps);
    for (uint32_t i = hashOf(chart, x, y);; ++i) {
        int entry = m.table[i & m.tableMask];
        if (entry == 0) return -1;
        const Texel &t = m.texels[entry - 1];
        if (t.chart == chart && t.x == x && t.y == y) return entry - 1;
    }
}

// Has a texel looked at for cells as small as those of `level`.
void wake(Model &m, int number, int level) {
    Texel &t = m.texels[number];
    if (t.level < level) t.level = (uint8_t)level;
    if (t.fresh) return;
    t.fresh = true;
    m.fresh[m.freshCount++] = number;
}

int findOrAdd(Model &m, int chart, int x, int y, int level) {
    int number = find(m, chart, x, y);
    if (number < 0) {
        number = m.texelCount++;
        m.texels[number] = {chart, x, y, (uint8_t)level, 0, false, false};
        uint32_t i = hashOf(chart, x, y);
        while (m.table[i & m.tableMask]) ++i;
        m.table[i & m.tableMask] = number + 1;
        wake(m, number, level);
    } else if (m.texels[number].level < level) {
        wake(m, number, level);
    }
    return number;
}

// A cell's quarter at corner k is the place 3 - k of the texel there.
bool quarterIsVisible(const Model &m, const Cell &cell, int k) {
    return m.texels[cell.corner[k]].visible >> (3 - k) & 1;
}
float visibleArea(const Model &m, const Cell &cell) {
    int quarters = 0;
    for (int k = 0; k < 4; ++k) quarters += quarterIsVisible(m, cell, k);
    return cell.area * 0.25f * (float)quarters;
}

// What hangs between two corners of a cell has the mean of what it hangs between.
void tieBetween(Model &m, int a, int b) {
    const Texel &p = m.texels[a], &q = m.texels[b];
    int x = p.x + q.x, y = p.y + q.y;
    if ((x | y) & 1) return; // between the finest
    int middle = find(m, p.chart, x / 2, y / 2);
    if (middle < 0 || m.tieCount + 2 > m.tieRoom) return;
    m.ties[m.tieCount++] = {middle, a, 1};
    m.ties[m.tieCount++] = {middle, b, 0.5f};
    tieBetween(m, a, middle);
    tieBetween(m, middle, b);
}

} // namespace

Texels8 loadTexels(const Model &model, const int *numbers, int count) {
    Texels8 t;
    for (int k = 0; k < 8; ++k) {
        const Texel &texel = model.texels[numbers[min(k, count - 1)]];
        const Chart &c = model.charts[texel.chart];
        float du = c.width / (float)(c.across * kSteps), dv = c.height / (float)(c.down * kSteps);
        put(t.p, k, c.at((float)texel.x * du, (float)texel.y * dv));
        put(t.u, k, c.u), put(t.v, k, c.v), put(t.n, k, c.n);
        float quarter = (float)kSteps / (float)(4 << texel.level);
        t.du[k] = du * quarter, t.dv[k] = dv * quarter;
        t.off[k] = c.off();
    }
    t.active = kLanes < count;
    return t;
}

Places8 placesOf(const int *masks, int round) {
    Places8 places = {};
    for (int k = 0; k < 8; ++k) {
        int mask = masks[k];
        for (int i = 0; i < round; ++i) mask &= mask - 1;
        if (!mask) continue;
        int number = __builtin_ctz((unsigned)mask);
        places.x[k] = number & 1 ? 1 : -1, places.y[k] = number & 2 ? 1 : -1;
        places.number[k] = number;
        places.active[k] = -1;
    }
    return places;
}

void findVisible(Model &model, const Scene &scene, Workers &workers) {
    static constexpr int kPiece = 64;
    parallelFor(workers, (model.freshCount + kPiece - 1) / kPiece, [&](int piece, int) {
        for (int i = piece * kPiece; i < min(piece * kPiece + kPiece, model.freshCount); i += 8) {
            int count = min(model.freshCount - i, 8), masks[8] = {}, visible[8] = {};
            for (int k = 0; k < 4 * count; ++k) {
                const Texel &t = model.texels[model.fresh[i + k / 4]];
                const Chart &c = model.charts[t.chart];
                float quarter = (float)kSteps * 0.25f / (float)(1 << t.level);
                float u = (float)t.x + (k & 1 ? quarter : -quarter),
                      v = (float)t.y + (k & 2 ? quarter : -quarter);
                masks[k / 4] |= onFacet(model, c, u * c.width / (float)(c.across * kSteps),
                                        v * c.height / (float)(c.down * kSteps))
                                << (k & 3);
            }
            Texels8 t = loadTexels(model, model.fresh + i, count);
            for (int round = 0; round < 4; ++round) {
                Places8 places = placesOf(masks, round);
                if (!any(places.active)) break;
                Int8 open = places.active & ~insideSolid(model, scene, t, places);
                for (int k = 0; k < 8; ++k)
                    if (open[k]) visible[k] |= 1 << places.number[k];
            }
            for (int k = 0; k < count; ++k) model.texels[model.fresh[i + k]].visible = (uint8_t)visible[k];
        }
    });
}

void settleFresh(Model &m) {
    for (int i = 0; i < m.freshCount; ++i) m.texels[m.fresh[i]].fresh = false;
    m.freshCount = 0;
}

void split(Model &m, int index) {
    if (m.cellCount + 4 > m.cellRoom || m.texelCount + 5 > m.texelRoom) return;
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

// Whether some of a cell, or all that was looked at, is hidden although it lies on a facet: what is to be
// seen of it may be small.
static bool partlyHidden(const Model &m, const Cell &cell) {
    int quarters = 0;
    for (int k = 0; k < 4; ++k) quarters += quarterIsVisible(m, cell, k);
    if (quarters == 4 || (quarters == 0 && cell.level > 0)) return false;
    const Chart &c = m.charts[cell.chart];
    const Texel &low = m.texels[cell.corner[0]], &high = m.texels[cell.corner[3]];
    float du = c.width / (float)(c.across * kSteps), dv = c.height / (float)(c.down * kSteps);
    for (int i = c.firstFacet; i < c.firstFacet + c.facetsCount; ++i) {
        const Facet &f = m.facets[i];
        if (f.triangle()) continue; // it fills half of its rectangle anyway
        float u0 = min(min(f.u[0], f.u[1]), f.u[2]), u1 = max(max(f.u[0], f.u[1]), f.u[2]),
              v0 = min(min(f.v[0], f.v[1]), f.v[2]), v1 = max(max(f.v[0], f.v[1]), f.v[2]);
        if (u0 < (float)high.x * du && u1 > (float)low.x * du && v0 < (float)high.y * dv &&
            v1 > (float)low.y * dv)
            return true;
    }
    return false;
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
                    if (unknown(a) && !unknown(b) && m.tieCount < m.tieRoom) m.ties[m.tieCount++] = {a, b, 1};
        }
        // The mean of all that was found for one
        for (int i = begin; i < m.tieCount; ++i) {
            Texel &t = m.texels[m.ties[i].texel];
            if (!t.filled) t.level = 0; // from now on it counts
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
    // Those that hang
    for (int i = 0; i < m.cellCount; ++i) {
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

void meansOfPatches(const Model &m, const float *plane, float *mean, int stride) {
    for (int i = 0; i < m.patchCount; ++i) mean[(size_t)i * (size_t)stride] = 0;
    for (int i = 0; i < m.cellCount; ++i) {
        const Cell &cell = m.cells[i];
        if (cell.divided()) continue;
        float sum = 0;
        for (int k = 0; k < 4; ++k)
            if (quarterIsVisible(m, cell, k)) sum += plane[cell.corner[k]];
        mean[(size_t)cell.patch * (size_t)stride] += sum * cell.area * 0.25f;
    }
    for (int i = 0; i < m.patchCount; ++i)
        if (m.patches[i].area > 0) mean[(size_t)i * (size_t)stride] /= m.patches[i].area;
}

void addToTexels(const Model &m, const float *values, int columns, float *const *planes, int count,
                 Workers &workers, int tied) {
    static constexpr int kPiece = 1024;
    parallelFor(workers, (m.texelCount + kPiece - 1) / kPiece, [&](int piece, int) {
        for (int i = piece * kPiece; i < min(piece * kPiece + kPiece, m.texelCount); ++i) {
            const Texel &t = m.texels[i];
            const Chart &c = m.charts[t.chart];
            // Between which two middles it lies, and where
            auto place = [](int x, int size, int patches, int &first, int &next) {
                float at = (float)x / (float)(size * kSteps) - 0.5f;
                first = clamp((int)(at + 1) - 1, 0, max(patches - 2, 0));
                next = min(first + 1, patches - 1);
                return broadcast(patches > 1 ? at - (float)first : 0.f);
            };
            int across = c.patchesAcross(), x0, x1, y0, y1;
            Float8 x = place(t.x, c.patchAcross, across, x0, x1),
                   y = place(t.y, c.patchDown, c.patchesDown(), y0, y1);
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
                if (k < tied) {
                    Float8 inside = between(saturate(x), saturate(y));
                    if (k == 0 && v[0] < least[0]) share = (inside[0] - least[0]) / (inside[0] - v[0]);
                    least = select(kLanes < tied - k, inside + (v - inside) * share, least);
                    v = select(kLanes < tied - k, least, v);
                }
                v = max(v, least);
                for (int j = 0; j < min(count - k, 8); ++j) planes[k + j][i] += v[j];
            }
        }
    });
}

} // namespace odraz
