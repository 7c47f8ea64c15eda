#include "tools/radiosity/baked.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/arrays.h"
#include "tools/radiosity/facets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace odraz {

namespace {

constexpr char kMagic[] = "odraz radiosity 2\n";

} // namespace

Baked::Baked(const Bake &b) {
    for (size_t i = 0; i < b.material.size(); ++i)
        reflects.push_back(b.reflects((int)i)), emits.push_back(b.emits((int)i));
    pictured = b.pictured.ofCell;
    if (b.byRays) {
        charts = b.regions.charts, facets = b.regions.facets;
        cells = b.cells, texels = b.texels, light = b.arrives;
        return;
    }
    const Model &m = *b.model;
    charts.assign(m.charts, m.charts + m.chartCount);
    facets.assign(m.facets, m.facets + m.facetCount);
    cells.assign(m.cells, m.cells + m.cellCount);
    texels.assign(m.texels, m.texels + m.texelCount);
    for (int i = 0; i < m.texelCount; ++i) light.push_back({b.light[0][i], b.light[1][i], b.light[2][i]});
}

void Baked::save(const std::string &path) const {
    std::string body;
    put(body, charts), put(body, facets), put(body, cells), put(body, texels);
    put(body, light), put(body, reflects), put(body, emits), put(body, pictured);
    writeWhole(path, withChecksum(body));
}

std::string Baked::withChecksum(const std::string &body) { return odraz::withChecksum(kMagic, body); }

Baked::Baked(const std::string &path) {
    std::string all = readWhole(path);
    size_t at = bodyOf(all, kMagic);
    if (!at) throw std::runtime_error(path + ": was not written by 'radiosity solve'");
    bool good = at != std::string::npos && get(all, at, charts) && get(all, at, facets) &&
                get(all, at, cells) && get(all, at, texels) && get(all, at, light) &&
                get(all, at, reflects) && get(all, at, emits) && get(all, at, pictured) && at == all.size() &&
                sound(*this);
    if (!good)
        throw std::runtime_error(path + ": is damaged, or from another version: solve the model again");
}

Rgb Baked::reflectsOf(int cell) const {
    return pictured.empty() ? reflects[(size_t)cells[(size_t)cell].chart] : pictured[(size_t)cell];
}

Rgb Baked::lightIn(int cell, float u, float v) const {
    // In steps of the finest cells, within this one
    const Chart &c = charts[(size_t)cells[(size_t)cell].chart];
    const int *corner = cells[(size_t)cell].corner;
    const Texel &low = texels[(size_t)corner[0]], &high = texels[(size_t)corner[3]];
    auto share = [](float x, int low, int high) {
        return std::clamp((x - (float)low) / (float)(high - low), 0.f, 1.f);
    };
    float x = share(u / c.width * (float)(c.across * kSteps), low.x, high.x),
          y = share(v / c.height * (float)(c.down * kSteps), low.y, high.y);
    auto l = [&](int k) { return light[(size_t)corner[k]]; };
    return lerp(lerp(l(0), l(1), x), lerp(l(2), l(3), x), y);
}

Rgb Baked::radiosityIn(int cell, float u, float v) const {
    return lightIn(cell, u, v) * reflectsOf(cell) + emits[(size_t)cells[(size_t)cell].chart];
}

Baked::Spot Baked::spotAt(int chart, const Vec3 &p) const {
    const Chart &c = charts[(size_t)chart];
    float u = std::clamp(dot(p - c.corner, c.u), 0.f, c.width),
          v = std::clamp(dot(p - c.corner, c.v), 0.f, c.height);
    return {cellAt(cells.data(), c, {u, v}), u, v};
}

Rgb Baked::lightAt(int chart, const Vec3 &p) const {
    Spot s = spotAt(chart, p);
    return lightIn(s.cell, s.u, s.v);
}

Rgb Baked::radiosityAt(int chart, const Vec3 &p) const {
    Spot s = spotAt(chart, p);
    return radiosityIn(s.cell, s.u, s.v);
}

size_t Baked::elements() const {
    size_t count = 0;
    int last = -1;
    forPieces([&](int, int cell, const std::vector<BakedPoint> &) { count += cell != last, last = cell; });
    return count;
}

namespace {

// Which facets may lie in a cell that was not divided: a plane of thousands of them is not to be searched for
// each of its thousands of cells.
class FacetsByCell {
public:
    FacetsByCell(const std::vector<Chart> &charts, const std::vector<Facet> &facets) : charts(charts) {
        for (const Chart &c : charts) {
            if (c.facetsCount <= kFew) continue;
            auto &lists = many[&c];
            lists.resize((size_t)c.across * (size_t)c.down);
            // Facets of a plane do not overlap: but for files that lie
            int64_t room = 64 * ((int64_t)lists.size() + c.facetsCount);
            for (int f = c.firstFacet; f < c.firstFacet + c.facetsCount && room >= 0; ++f)
                room -= list(f, outlineOf(facets[(size_t)f]), c, lists);
            if (room < 0) many.erase(&c);
        }
    }
    const std::vector<int> &of(int chart, int x, int y) {
        const Chart &c = charts[(size_t)chart];
        if (auto found = many.find(&c); found != many.end()) return found->second[(size_t)(y * c.across + x)];
        few.clear();
        for (int f = c.firstFacet; f < c.firstFacet + c.facetsCount; ++f) few.push_back(f);
        return few;
    }

private:
    static constexpr int kFew = 16;
    const std::vector<Chart> &charts;

    // Row by row, since slivers lie across many. Returns how much work it was.
    static int64_t list(int facet, const Outline &outline, const Chart &c,
                        std::vector<std::vector<int>> &lists) {
        float wide = c.width / (float)c.across, tall = c.height / (float)c.down, low = c.height, high = 0;
        for (const PlanePoint &p : outline) low = std::min(low, p.v), high = std::max(high, p.v);
        auto cell = [](float at, float size, int count) {
            return (int)std::clamp(at / size, 0.f, (float)(count - 1));
        };
        int64_t work = 0;
        for (int y = cell(low, tall, c.down); y <= cell(high, tall, c.down); ++y) {
            float v0 = ((float)y - 1e-3f) * tall, v1 = ((float)y + 1.001f) * tall;
            Outline row = cut(cut(outline, {0, v0}, {1, v0}), {1, v1}, {0, v1});
            float left = c.width, right = 0;
            for (const PlanePoint &p : row) left = std::min(left, p.u), right = std::max(right, p.u);
            int first = cell(left - 1e-3f * wide, wide, c.across),
                last = cell(right + 1e-3f * wide, wide, c.across);
            work += 1 + std::max(last - first, 0);
            for (int x = first; x <= last && !row.empty(); ++x)
                lists[(size_t)(y * c.across + x)].push_back(facet);
        }
        return work;
    }
    std::unordered_map<const Chart *, std::vector<std::vector<int>>> many;
    std::vector<int> few;
};

} // namespace

void Baked::forPieces(const std::function<void(int, int, const std::vector<BakedPoint> &)> &visit) const {
    // Texels by their place, to find those that hang in sides
    struct Key {
        int chart, x, y;
        bool operator<(const Key &b) const {
            return chart != b.chart ? chart < b.chart : y != b.y ? y < b.y : x < b.x;
        }
    };
    std::vector<Key> known;
    bool divided = std::any_of(cells.begin(), cells.end(), [](const Cell &c) { return c.divided(); });
    if (divided) {
        for (const Texel &t : texels) known.push_back({t.chart, t.x, t.y});
        std::sort(known.begin(), known.end());
    }
    FacetsByCell byCell(charts, facets);
    std::vector<BakedPoint> piece;
    for (size_t i = 0; i < cells.size(); ++i) {
        const Cell &cell = cells[i];
        if (cell.divided()) continue;
        const Chart &c = charts[(size_t)cell.chart];
        const Texel &low = texels[(size_t)cell.corner[0]], &high = texels[(size_t)cell.corner[3]];
        float du = c.width / (float)(c.across * kSteps), dv = c.height / (float)(c.down * kSteps);
        // Its outline, counter-clockwise, with what hangs in it
        Outline outline;
        auto side = [&](int x0, int y0, int x1, int y1) {
            int steps = std::max(std::abs(x1 - x0), std::abs(y1 - y0));
            for (int k = 0; k < steps; ++k) {
                int x = x0 + (x1 - x0) * k / steps, y = y0 + (y1 - y0) * k / steps;
                if (k == 0 ||
                    (divided && std::binary_search(known.begin(), known.end(), Key{cell.chart, x, y})))
                    outline.push_back({(float)x * du, (float)y * dv});
            }
        };
        side(low.x, low.y, high.x, low.y);
        side(high.x, low.y, high.x, high.y);
        side(high.x, high.y, low.x, high.y);
        side(low.x, high.y, low.x, low.y);
        for (int f : byCell.of(cell.chart, low.x / kSteps, low.y / kSteps)) {
            Outline left = outline, facet = outlineOf(facets[(size_t)f]);
            for (size_t k = 0; k < facet.size() && left.size() > 2; ++k)
                left = cut(left, facet[k], facet[(k + 1) % facet.size()]);
            if (left.size() < 3 || !(areaOf(left) > 1e-5 * (double)cell.area)) continue;
            piece.clear();
            for (const PlanePoint &p : left) piece.push_back({c.at(p.u, p.v), radiosityIn((int)i, p.u, p.v)});
            visit(cell.chart, (int)i, piece);
        }
    }
}

} // namespace odraz
