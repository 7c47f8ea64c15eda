#include "tools/radiosity/regions.h"

#include "tools/radiosity/rectangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace odraz {

namespace {

constexpr double kEven = 0.999995; // the cosine of an angle between normals in one plane
constexpr size_t kBothSides = 4;   // edges of triangles that meet in a sheet that is lit from both sides

struct Edge {
    int low, high, triangle;
    bool forward; // from low to high
};

std::vector<Edge> sortedEdges(const Mesh &mesh) {
    std::vector<Edge> edges;
    edges.reserve(mesh.triangles.size() * 3);
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        for (size_t k = 0; k < 3; ++k) {
            int a = mesh.triangles[i].corners[k], b = mesh.triangles[i].corners[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), (int)i, a < b});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge &a, const Edge &b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    return edges;
}

// Sets of triangles that grow together.
struct Union {
    std::vector<int> parent;
    explicit Union(size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
    int root(int i) {
        while (parent[(size_t)i] != i) i = parent[(size_t)i] = parent[(size_t)parent[(size_t)i]];
        return i;
    }
};

// Things sorted by which set they belong to.
template <class T> struct Sorted {
    std::vector<size_t> first; // of each set, and the end of the last
    std::vector<T> things;

    // root(i): the set of the i-th of `count`, or -1; thing(i): what it is.
    template <class Root, class Thing> Sorted(size_t sets, size_t count, Root &&root, Thing &&thing) {
        first.resize(sets + 2);
        for (size_t i = 0; i < count; ++i) ++first[(size_t)(root(i) + 2)];
        for (size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        things.resize(first.back());
        for (size_t i = 0; i < count; ++i) things[first[(size_t)(root(i) + 1)]++] = thing(i);
    }
    std::span<const T> of(size_t set) const {
        return {things.data() + first[set], first[set + 1] - first[set]};
    }
};

struct Builder {
    const Mesh &mesh;
    Regions &regions;
    double tiny, cell;

    // Adds the triangles as one chart; false if they fill too little of its rectangle.
    bool add(std::span<const int> triangles, std::span<const Edge> borders) {
        // The plane, and a frame along the longest border
        Vec3d sum = {};
        for (int t : triangles) sum = sum + normalOf(mesh, mesh.triangles[(size_t)t]);
        Vec3d n = normalize(sum), along = {};
        const auto &points = mesh.points;
        for (const Edge &e : borders) {
            Vec3d side = points[(size_t)e.high] - points[(size_t)e.low];
            // The first of those that are about as long: copies of a model are divided alike
            if (dot(side, side) > dot(along, along) * 1.0001) along = side;
        }
        along = along - n * dot(along, n);
        Vec3d u = normalize(along), v = cross(n, u),
              origin = points[(size_t)mesh.triangles[(size_t)triangles[0]].corners[0]];
        auto place = [&](int p) {
            Vec3d d = points[(size_t)p] - origin;
            return Vec2d{dot(d, u), dot(d, v)};
        };
        Vec2d lo = {1e300, 1e300}, hi = {-1e300, -1e300};
        double twice = 0;
        for (int t : triangles) {
            for (int c : mesh.triangles[(size_t)t].corners) {
                Vec2d f = place(c);
                for (size_t k = 0; k < 2; ++k) lo[k] = std::min(lo[k], f[k]), hi[k] = std::max(hi[k], f[k]);
            }
            twice += length(normalOf(mesh, mesh.triangles[(size_t)t]));
        }
        double width = hi[0] - lo[0], tall = hi[1] - lo[1];
        std::vector<Rectangle> rectangles;
        if (triangles.size() > 1) {
            std::vector<std::array<Vec2d, 2>> flat;
            for (const Edge &e : borders) flat.push_back({place(e.low), place(e.high)});
            rectangles = rectanglesOf(flat, tiny);
            if (rectangles.empty() && twice < 0.6 * width * tall) return false;
        }

        int number = (int)regions.charts.size(), material = mesh.triangles[(size_t)triangles[0]].material;
        auto cells = [&](double side) {
            return (int16_t)std::clamp((float)side / (float)cell + 0.5f, 1.f, (float)kMaxAcross);
        };
        // In double: neighbours' corners meet as nearly as floats can
        Chart c = {};
        c.corner = toFloat(origin + (u * lo[0] + v * lo[1]));
        c.u = toFloat(u), c.v = toFloat(v), c.n = toFloat(n);
        c.width = (float)width, c.height = (float)tall;
        c.across = cells(width), c.down = cells(tall);
        c.material = (uint16_t)material;
        c.firstFacet = (int)regions.facets.size();
        auto facet = [&](std::array<Vec2d, 4> corners) {
            Facet f = {number, {}, {}};
            for (size_t k = 0; k < 4; ++k)
                f.u[k] = (float)(corners[k][0] - lo[0]), f.v[k] = (float)(corners[k][1] - lo[1]);
            regions.facets.push_back(f);
        };
        for (const Rectangle &r : rectangles)
            facet({{{r.u0, r.v0}, {r.u1, r.v0}, {r.u1, r.v1}, {r.u0, r.v1}}});
        if (rectangles.empty())
            for (int t : triangles) {
                const auto &k = mesh.triangles[(size_t)t].corners;
                facet({place(k[0]), place(k[1]), place(k[2]), place(k[2])});
            }
        c.facetsCount = (int)regions.facets.size() - c.firstFacet;
        regions.charts.push_back(c);
        regions.material.push_back(material);
        for (int t : triangles) regions.chartOf[(size_t)t] = number;
        return true;
    }
};

} // namespace

void poseFacets(const Model &model, Scene &scene) {
    for (int i = 0; i < model.facetCount; ++i) {
        const Facet &f = model.facets[i];
        const Chart &c = model.charts[f.chart];
        Shape s = model.shapeOf(i);
        if (f.triangle()) {
            Vec3 corner = f.corner(c, 0);
            s = triangle(corner, f.corner(c, 1) - corner, f.corner(c, 2) - corner, c.n);
        }
        s.chart = f.chart;
        s.material = 0;
        scene.add(s);
    }
}

void fillModel(Model &model, const Regions &regions) {
    if (regions.charts.size() > (size_t)kMaxCharts || regions.facets.size() > (size_t)kMaxFacets)
        throw ModelError(
            "more than " + std::to_string(kMaxFacets) +
            " polygons are left after joining those in one plane: leave out --hemicube, --patch, "
            "--adaptive and --direct, and light goes by rays");
    std::copy(regions.charts.begin(), regions.charts.end(), model.charts);
    std::copy(regions.facets.begin(), regions.facets.end(), model.facets);
    model.chartCount = (int)regions.charts.size(), model.facetCount = (int)regions.facets.size();
}

Regions joinRegions(const Mesh &mesh, double cell) {
    if (mesh.materials.size() > 65535) throw ModelError("a model may have 65535 materials at most");
    size_t count = mesh.triangles.size();
    std::vector<Vec3d> normals(count);
    for (size_t i = 0; i < count; ++i) normals[i] = normalize(normalOf(mesh, mesh.triangles[i]));
    double tiny = mesh.size() * 5e-6;
    auto joins = [&](int a, int b) {
        const Triangle &s = mesh.triangles[(size_t)a], &t = mesh.triangles[(size_t)b];
        if (s.material != t.material || dot(normals[(size_t)a], normals[(size_t)b]) < kEven) return false;
        for (int c : t.corners)
            if (std::fabs(dot(mesh.points[(size_t)c] - mesh.points[(size_t)s.corners[0]],
                              normals[(size_t)a])) > tiny)
                return false;
        return true;
    };

    auto oneSheet = [&](std::span<const Edge> all) {
        if (all.size() == 2) return true;
        if (all.size() != kBothSides) return false;
        size_t fronts = 0;
        for (const Edge &e : all) {
            double angle = dot(normals[(size_t)all[0].triangle], normals[(size_t)e.triangle]);
            if (std::fabs(angle) < kEven) return false;
            fronts += angle > 0;
        }
        return fronts == kBothSides / 2;
    };

    // Grow regions over edges that two triangles share, turning the same way
    std::vector<Edge> edges = sortedEdges(mesh);
    Union sets(count);
    Regions regions;
    regions.off = tiny;
    for (size_t i = 0; i < edges.size();) {
        size_t end = i + 1;
        while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
            ++end;
        // Of one sheet, or of one that is lit from both sides: front to front, back to back
        for (size_t k = i; k + 1 < end && oneSheet({&edges[i], end - i}); ++k)
            for (size_t l = k + 1; l < end; ++l) {
                int s = edges[k].triangle, t = edges[l].triangle, a = sets.root(s), b = sets.root(t);
                // Against the region's first triangle: no drift along a bent surface
                if (edges[k].forward != edges[l].forward && a != b && joins(std::min(a, b), s) &&
                    joins(std::min(a, b), t))
                    sets.parent[(size_t)std::max(a, b)] = std::min(a, b);
            }
        i = end;
    }

    // Their triangles and borders: edges that are not met in both directions
    std::vector<int> roots(count);
    for (size_t i = 0; i < count; ++i) roots[i] = sets.root((int)i);
    Sorted<int> members(
        count, count, [&](size_t i) { return roots[i]; }, [](size_t i) { return (int)i; });
    auto borderOf = [&](size_t i) {
        int root = roots[(size_t)edges[i].triangle];
        for (size_t k = i - std::min(i, kBothSides - 1); k < std::min(i + kBothSides, edges.size()); ++k)
            if (k != i && edges[k].low == edges[i].low && edges[k].high == edges[i].high &&
                edges[k].forward != edges[i].forward && roots[(size_t)edges[k].triangle] == root)
                return -1;
        return root;
    };
    Sorted<Edge> borders(count, edges.size(), borderOf, [&](size_t i) { return edges[i]; });
    regions.chartOf.resize(count);
    Builder builder = {mesh, regions, tiny, cell};
    for (size_t i = 0; i < count; ++i) {
        if (members.of(i).empty() || builder.add(members.of(i), borders.of(i))) continue;
        // Little of a rectangle: every triangle for itself
        for (int t : members.of(i)) {
            const auto &c = mesh.triangles[(size_t)t].corners;
            const Edge sides[] = {{c[0], c[1], t, true}, {c[1], c[2], t, true}, {c[2], c[0], t, true}};
            builder.add({&t, 1}, sides);
        }
    }
    return regions;
}

} // namespace odraz
