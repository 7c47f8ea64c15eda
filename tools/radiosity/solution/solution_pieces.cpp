// Cuts elements into the pieces that lie on facets.
#include "tools/radiosity/solution/solution.h"

#include "tools/radiosity/divide/facets.h"

#include <algorithm>

namespace odraz::radiosity {

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
    using Grid = std::vector<std::vector<int>>; // of each cell of a chart; empty: of none
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
