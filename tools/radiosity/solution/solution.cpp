#include "tools/radiosity/solution/solution.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/divide/facets.h"
#include "tools/radiosity/solution/arrays.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

// Whether a number is finite, and so small that products of several such numbers are finite too.
bool moderate(float x) { return std::fabs(x) < 1e18f; }
bool moderate(const Vec3 &v) { return moderate(v.x) && moderate(v.y) && moderate(v.z); }
// Whether `count` items from index `first` on lie within a list of `all`.
bool within(int first, int64_t count, size_t all) {
    return first >= 0 && count >= 0 && (int64_t)first + count <= (int64_t)all;
}

bool valid(const Chart &c, const Solution &b) {
    uint8_t open; // read as a byte: a bool other than 0 and 1 is undefined
    std::memcpy(&open, &c.open, 1);
    return moderate(c.corner) && moderate(c.u) && moderate(c.v) && moderate(c.n) && moderate(c.width) &&
           moderate(c.height) && c.width > 0 && c.height > 0 && open <= 1 && c.across > 0 && c.down > 0 &&
           within(c.firstCell, (int64_t)c.across * c.down, b.cells.size()) &&
           within(c.firstFacet, c.facetCount, b.facets.size());
}

bool valid(const Facet &f, const Solution &b) {
    bool good = within(f.chart, 1, b.charts.size());
    for (int k = 0; k < 4; ++k) good &= moderate(f.u[k]) && moderate(f.v[k]);
    return good;
}

bool valid(const Cell &c, const Solution &b) {
    if (!within(c.chart, 1, b.charts.size()) || !moderate(c.area)) return false;
    for (int corner : c.corner)
        if (!within(corner, 1, b.texels.size()) || b.texels[(size_t)corner].chart != c.chart) return false;
    const Texel &low = b.texels[(size_t)c.corner[0]], &high = b.texels[(size_t)c.corner[3]];
    return low.x < high.x && low.y < high.y;
}

bool valid(const Texel &t, const Solution &b) {
    if (!within(t.chart, 1, b.charts.size())) return false;
    const Chart &c = b.charts[(size_t)t.chart];
    return t.x >= 0 && t.y >= 0 && t.x <= c.across && t.y <= c.down;
}

} // namespace

bool valid(const Solution &b) {
    auto all = [](const auto &list, auto good) { return std::all_of(list.begin(), list.end(), good); };
    auto finite = [&](const std::vector<Rgb> &list) {
        return all(list, [](const Rgb &c) { return moderate(c); });
    };
    auto named = [&](const std::vector<int> &offsets) {
        return offsets.empty() ||
               (offsets.size() == b.charts.size() && !b.names.empty() && b.names.back() == 0 &&
                all(offsets, [&](int at) { return within(at, 1, b.names.size()); }));
    };
    return moderate(b.origin) && !b.charts.empty() && b.light.size() == b.texels.size() &&
           b.reflects.size() == b.charts.size() && b.emits.size() == b.charts.size() && finite(b.light) &&
           finite(b.reflects) && finite(b.emits) && finite(b.cellReflects) &&
           (b.cellReflects.empty() || b.cellReflects.size() == b.cells.size()) && named(b.material) &&
           named(b.object) && named(b.group) && all(b.charts, [&](const Chart &c) { return valid(c, b); }) &&
           all(b.facets, [&](const Facet &f) { return valid(f, b); }) &&
           all(b.texels, [&](const Texel &t) { return valid(t, b); }) &&
           all(b.cells, [&](const Cell &c) { return valid(c, b); });
}

void Solution::put(std::string &to) const {
    const std::vector<Vec3> origins = {origin};
    radiosity::put(to, origins, charts, facets, cells, texels, light, reflects, emits, cellReflects, material,
                   object, group, names);
}

bool Solution::get(const std::string &from, size_t &at) {
    std::vector<Vec3> origins;
    if (!radiosity::get(from, at, origins, charts, facets, cells, texels, light, reflects, emits,
                        cellReflects, material, object, group, names) ||
        origins.size() != 1)
        return false;
    origin = origins[0];
    return valid(*this);
}

void Solution::save(const std::string &path) const {
    if (!valid(*this))
        throw std::runtime_error(path + ": is not written: its numbers are too large for a solution");
    std::string body;
    put(body);
    common::writeWhole(path, withChecksum(kSolutionMagic, body));
}

Solution::Solution(const std::string &path) {
    std::string all = common::readWhole(path);
    size_t at = bodyOf(all, kSolutionMagic);
    if (!at) throw std::runtime_error(path + ": was not written by 'radiosity solve'");
    bool good = at != std::string::npos && get(all, at) && at == all.size();
    if (!good)
        throw std::runtime_error(path + ": is damaged, or from another version: solve the model again");
}

std::string Solution::nameOf(const std::vector<int> &offsets, int chart) const {
    std::string name = offsets.empty() ? "" : &names[(size_t)offsets[(size_t)chart]];
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < ' '; }, '?');
    return name;
}

Rgb Solution::reflectsOf(int cell) const {
    return cellReflects.empty() ? reflects[(size_t)cells[(size_t)cell].chart] : cellReflects[(size_t)cell];
}

Rgb Solution::bilinear(const std::vector<Rgb> &texelValues, int cell, float u, float v) const {
    // The position within the cell
    const Chart &c = charts[(size_t)cells[(size_t)cell].chart];
    const int *corner = cells[(size_t)cell].corner;
    const Texel &low = texels[(size_t)corner[0]], &high = texels[(size_t)corner[3]];
    auto share = [](float x, int low, int high) {
        return std::clamp((x - (float)low) / (float)(high - low), 0.f, 1.f);
    };
    float x = share(u / c.width * (float)c.across, low.x, high.x),
          y = share(v / c.height * (float)c.down, low.y, high.y);
    auto l = [&](int k) { return texelValues[(size_t)corner[k]]; };
    return lerp(lerp(l(0), l(1), x), lerp(l(2), l(3), x), y);
}

Rgb Solution::lightIn(int cell, float u, float v) const { return bilinear(light, cell, u, v); }

Rgb Solution::radiosityIn(int cell, float u, float v) const {
    Rgb all = lightIn(cell, u, v) * reflectsOf(cell) + emits[(size_t)cells[(size_t)cell].chart];
    return gloss.empty() ? all : all + bilinear(gloss, cell, u, v);
}

Solution::CellPoint Solution::cellPointAt(int chart, const Vec3 &p) const {
    const Chart &c = charts[(size_t)chart];
    float u = std::clamp(dot(p - c.corner, c.u), 0.f, c.width),
          v = std::clamp(dot(p - c.corner, c.v), 0.f, c.height);
    return {cellAt(c, {u, v}), u, v};
}

Rgb Solution::lightAt(int chart, const Vec3 &p) const {
    CellPoint s = cellPointAt(chart, p);
    return lightIn(s.cell, s.u, s.v);
}

Rgb Solution::radiosityAt(int chart, const Vec3 &p) const {
    CellPoint s = cellPointAt(chart, p);
    return radiosityIn(s.cell, s.u, s.v);
}

// --- Pieces: elements cut to the parts that lie on facets ---

void PieceSum::add(const std::vector<SolutionPoint> &piece) {
    // Divide the piece into a fan of triangles
    for (size_t i = 2; i < piece.size(); ++i) {
        const SolutionPoint *t[3] = {&piece[0], &piece[i - 1], &piece[i]};
        double part = (double)length(cross(t[1]->p - t[0]->p, t[2]->p - t[0]->p)) / 2;
        area += part;
        for (const SolutionPoint *q : t)
            p = p + toDouble(q->p) * (part / 3), radiosity = radiosity + toDouble(q->radiosity) * (part / 3);
    }
}

size_t Solution::elements() const {
    size_t count = 0;
    int last = -1;
    forPieces([&](int, int cell, const std::vector<SolutionPoint> &) { count += cell != last, last = cell; });
    return count;
}

namespace {

// Lists, for each cell, the facets that may overlap it, so that a cell need not search all facets.
class FacetsByCell {
public:
    FacetsByCell(const std::vector<Chart> &charts, const std::vector<Facet> &facets)
        : charts(charts), grids(charts.size()) {
        for (size_t i = 0; i < charts.size(); ++i) {
            const Chart &c = charts[i];
            if (c.facetCount <= kFewFacets) continue;
            Grid &lists = grids[i];
            lists.resize((size_t)c.across * (size_t)c.down);
            // Limit the work: facets in one plane do not overlap, except in forged files
            int64_t room = 64 * ((int64_t)lists.size() + c.facetCount);
            for (int f = c.firstFacet; f < c.firstFacet + c.facetCount && room >= 0; ++f)
                room -= list(f, outlineOf(facets[(size_t)f]), c, lists);
            if (room < 0) lists.clear();
        }
    }
    const std::vector<int> &of(int chart, int x, int y) {
        const Chart &c = charts[(size_t)chart];
        if (const Grid &grid = grids[(size_t)chart]; !grid.empty()) return grid[(size_t)(y * c.across + x)];
        allFacets.clear();
        for (int f = c.firstFacet; f < c.firstFacet + c.facetCount; ++f) allFacets.push_back(f);
        return allFacets;
    }

private:
    static constexpr int kFewFacets = 16;
    using Grid = std::vector<std::vector<int>>; // a list for each cell of a chart; empty: none
    const std::vector<Chart> &charts;

    // Adds a facet to its cells' lists, by rows, since slivers cross many cells. Returns the number of steps.
    static int64_t list(int facet, const Outline &outline, const Chart &c, Grid &lists) {
        float du = c.width / (float)c.across, dv = c.height / (float)c.down, low = c.height, high = 0;
        for (const PlanePoint &p : outline) low = std::min(low, p.v), high = std::max(high, p.v);
        auto cell = [](float at, float size, int count) {
            return (int)std::clamp(at / size, 0.f, (float)(count - 1));
        };
        int64_t work = 0;
        for (int y = cell(low, dv, c.down); y <= cell(high, dv, c.down); ++y) {
            float v0 = ((float)y - 1e-3f) * dv, v1 = ((float)y + 1.001f) * dv;
            Outline row = cut(cut(outline, {0, v0}, {1, v0}), {1, v1}, {0, v1});
            float left = c.width, right = 0;
            for (const PlanePoint &p : row) left = std::min(left, p.u), right = std::max(right, p.u);
            int first = cell(left - 1e-3f * du, du, c.across), last = cell(right + 1e-3f * du, du, c.across);
            work += 1 + std::max(last - first, 0);
            for (int x = first; x <= last && !row.empty(); ++x)
                lists[(size_t)(y * c.across + x)].push_back(facet);
        }
        return work;
    }
    std::vector<Grid> grids;
    std::vector<int> allFacets;
};

} // namespace

void Solution::forPieces(
    const std::function<void(int, int, const std::vector<SolutionPoint> &)> &visit) const {
    FacetsByCell byCell(charts, facets);
    std::vector<SolutionPoint> piece;
    for (size_t i = 0; i < cells.size(); ++i) {
        const Cell &cell = cells[i];
        const Chart &c = charts[(size_t)cell.chart];
        const Texel &low = texels[(size_t)cell.corner[0]], &high = texels[(size_t)cell.corner[3]];
        float du = c.width / (float)c.across, dv = c.height / (float)c.down, u0 = (float)low.x * du,
              v0 = (float)low.y * dv, u1 = (float)high.x * du, v1 = (float)high.y * dv;
        for (int f : byCell.of(cell.chart, low.x, low.y)) {
            Outline left = {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}}, facet = outlineOf(facets[(size_t)f]);
            for (size_t k = 0; k < facet.size() && left.size() > 2; ++k)
                left = cut(left, facet[k], facet[(k + 1) % facet.size()]);
            if (left.size() < 3 || !(areaOf(left) > 1e-5 * (double)cell.area)) continue;
            piece.clear();
            for (const PlanePoint &p : left) piece.push_back({c.at(p.u, p.v), radiosityIn((int)i, p.u, p.v)});
            visit(cell.chart, (int)i, piece);
        }
    }
}

} // namespace odraz::radiosity
