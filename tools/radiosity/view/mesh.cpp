#include "tools/radiosity/view/mesh.h"

#include "trace/scene/bounds.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

namespace odraz::radiosity {

namespace {

ViewPoint pointOf(const Vec3 &p, const Vec3 &n, uint32_t patch) {
    auto shorter = [](float x) { return (int16_t)std::lround(x * 32767); };
    return {p, {shorter(n.x), shorter(n.y), shorter(n.z), 0}, patch};
}

// A piece of an element.
struct Piece {
    size_t patch;
    Vec3 middle, n; // its centroid and normal
    float area;
    bool visible;
};

// Whether any part of a cell is visible. Cells inside solids are not, and have no hemicube.
bool visible(const Solution &b, const Cell &cell) {
    for (int k = 0; k < 4; ++k)
        if (b.texels[(size_t)cell.corner[k]].visible >> (3 - k) & 1) return true;
    return false;
}

// Places each patch's hemicube at the patch's centroid if that lies on one of its elements, otherwise at the
// centroid of the nearest element.
std::vector<ViewPatch> placeHemicubes(const std::vector<Piece> &pieces, size_t patches) {
    struct Sum {
        Vec3d p = {};
        double area = 0;
        float nearest = kInfinity;
        bool seen = false;
    };
    std::vector<Sum> sums(patches);
    for (const Piece &m : pieces) {
        Sum &s = sums[m.patch];
        if (m.visible && !s.seen) s = {}, s.seen = true; // hidden pieces count only if all are hidden
        if (m.visible != s.seen) continue;
        s.p = s.p + toDouble(m.middle * m.area);
        s.area += (double)m.area;
    }
    std::vector<ViewPatch> placed(patches);
    for (const Piece &m : pieces) {
        Sum &s = sums[m.patch];
        Vec3 mean = toFloat(s.p / std::max(s.area, 1e-300));
        float distance = length(mean - m.middle), side = std::sqrt(m.area);
        if (m.visible != s.seen || distance >= s.nearest) continue;
        s.nearest = distance;
        bool onElement = distance < 0.75f * side && std::fabs(dot(mean - m.middle, m.n)) < 1e-3f * side;
        placed[m.patch] = {onElement ? mean : m.middle, m.n};
    }
    return placed;
}

} // namespace

ViewMesh::ViewMesh(const Solution &solution) {
    std::unordered_map<int, uint32_t> numbers;
    std::vector<Piece> pieces;
    solution.forPieces([&](int chart, int cell, const std::vector<SolutionPoint> &piece) {
        const Chart &c = solution.charts[(size_t)chart];
        int patch = solution.cells[(size_t)cell].patch;
        uint32_t number = numbers.try_emplace(patch, (uint32_t)numbers.size() + 1).first->second;
        if (points.size() + piece.size() > 0x7fffffff || numbers.size() >= 1 << 24)
            throw std::runtime_error("there are too many elements to show: solve it with a larger --element");
        auto first = (uint32_t)points.size(), count = (uint32_t)piece.size();
        PieceSum sum;
        sum.add(piece);
        pieces.push_back({number - 1, sum.area > 0 ? toFloat(sum.p / sum.area) : piece[0].p, c.n,
                          (float)sum.area, visible(solution, solution.cells[(size_t)cell])});
        ViewPoint point = pointOf({}, c.n, number);
        for (uint32_t i = 0; i < count; ++i) {
            Vec3 from = piece[i].p - c.corner;
            point.p = piece[i].p;
            points.push_back(point);
            cellPoints.push_back({cell, dot(from, c.u), dot(from, c.v)});
            outlines.insert(outlines.end(), {first + i, first + (i + 1) % count});
            if (i >= 2) triangles.insert(triangles.end(), {first, first + i - 1, first + i});
        }
    });
    if (points.empty()) throw std::runtime_error("there is no element to show");
    patches = placeHemicubes(pieces, numbers.size());
    for (const Facet &f : solution.facets) {
        const Chart &c = solution.charts[(size_t)f.chart];
        int corners = f.triangle() ? 3 : 4;
        for (int k = 0; k < corners; ++k)
            for (int end : {k, (k + 1) % corners}) edges.push_back(pointOf(f.corner(c, end), c.n, 0));
    }
    Vec3 low = points[0].p, high = low;
    for (const ViewPoint &v : points) low = lower(low, v.p), high = upper(high, v.p);
    size = std::max(length(high - low), 1e-30f);
}

std::vector<Rgb> ViewMesh::light(const Solution &solution) const {
    std::vector<Rgb> light(cellPoints.size());
    for (size_t i = 0; i < light.size(); ++i) {
        const Solution::CellPoint &at = cellPoints[i];
        light[i] = solution.radiosityIn(at.cell, at.u, at.v);
    }
    return light;
}

} // namespace odraz::radiosity
