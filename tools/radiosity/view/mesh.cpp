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

// The centroid of a piece of an element, to place the hemicube of its patch.
struct PieceCentroid {
    Vec3 p, n;
    float area;
};

PieceCentroid centroidOf(const ViewPoint *points, size_t count, const Vec3 &n) {
    PieceCentroid m = {{}, n, 0};
    for (size_t i = 2; i < count; ++i) {
        const Vec3 &a = points[0].p, &b = points[i - 1].p, &c = points[i].p;
        float area = length(cross(b - a, c - a)) / 2;
        m.p += (a + b + c) * (area / 3);
        m.area += area;
    }
    m.p = m.area > 0 ? m.p * (1 / m.area) : points[0].p;
    return m;
}

// Whether any part of a cell is visible. Cells inside solids are not, and have no hemicube.
bool visible(const Solution &b, const Cell &cell) {
    for (int k = 0; k < 4; ++k)
        if (b.texels[(size_t)cell.corner[k]].visible >> (3 - k) & 1) return true;
    return false;
}

} // namespace

ViewMesh::ViewMesh(const Solution &solution) {
    std::unordered_map<int, uint32_t> numbers;
    std::vector<uint32_t> firsts; // index of each piece's first point
    solution.forPieces([&](int chart, int cell, const std::vector<SolutionPoint> &piece) {
        const Chart &c = solution.charts[(size_t)chart];
        int patch = solution.cells[(size_t)cell].patch;
        uint32_t number = numbers.try_emplace(patch, (uint32_t)numbers.size() + 1).first->second;
        if (points.size() + piece.size() > 0x7fffffff || numbers.size() >= 1 << 24)
            throw std::runtime_error("there are too many elements to show: solve it with a larger --element");
        auto first = (uint32_t)points.size(), count = (uint32_t)piece.size();
        firsts.push_back(first);
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
    patches.resize(numbers.size());
    placeHemicubes(solution, firsts);
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

// Places each patch's hemicube at the patch's centroid if that lies on one of its elements, otherwise at the
// centroid of the nearest element.
void ViewMesh::placeHemicubes(const Solution &solution, const std::vector<uint32_t> &firsts) {
    struct Sum {
        Vec3d p = {};
        double area = 0;
        float nearest = kInfinity;
        bool seen = false;
    };
    std::vector<Sum> sums(patches.size());
    auto all = [&](auto visit) {
        for (size_t i = 0; i < firsts.size(); ++i) {
            size_t first = firsts[i], end = i + 1 < firsts.size() ? firsts[i + 1] : points.size();
            const Cell &cell = solution.cells[(size_t)cellPoints[first].cell];
            visit(sums[points[first].patch - 1], patches[points[first].patch - 1], visible(solution, cell),
                  centroidOf(&points[first], end - first, solution.charts[(size_t)cell.chart].n));
        }
    };
    all([](Sum &s, ViewPatch &, bool seen, const PieceCentroid &m) {
        if (seen && !s.seen) s = {}, s.seen = true; // hidden pieces count only if all are hidden
        if (seen != s.seen) return;
        s.p = s.p + toDouble(m.p * m.area);
        s.area += (double)m.area;
    });
    all([](Sum &s, ViewPatch &to, bool seen, const PieceCentroid &m) {
        Vec3 mean = toFloat(s.p / std::max(s.area, 1e-300));
        float distance = length(mean - m.p);
        if (seen != s.seen || distance >= s.nearest) return;
        s.nearest = distance;
        float side = std::sqrt(m.area);
        bool onElement = distance < 0.75f * side && std::fabs(dot(mean - m.p, m.n)) < 1e-3f * side;
        to = {onElement ? mean : m.p, m.n};
    });
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
