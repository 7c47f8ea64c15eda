#include "tools/radiosity/regions.h"

#include "tools/radiosity/rectangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace odraz {

namespace {

Vec3 toFloat(Vec3d a) { return {(float)a.x, (float)a.y, (float)a.z}; }

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

struct Builder {
    const Mesh &mesh;
    Model &model;
    Regions &regions;
    double tiny, cell;

    // Adds the triangles as one chart; false if they fill too little of its rectangle.
    bool add(const std::vector<int> &triangles, const std::vector<Edge> &borders) {
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
        size_t pieces = rectangles.empty() ? triangles.size() : rectangles.size();
        if (model.chartCount == kMaxCharts || (size_t)model.facetCount + pieces > (size_t)kMaxFacets)
            throw ModelError("more than " + std::to_string(kMaxFacets) +
                             " polygons are left after joining those in one plane");

        Vec3d corner = origin + (u * lo[0] + v * lo[1]);
        model.addRect(toFloat(corner), toFloat(u) * (float)width, toFloat(v) * (float)tall, 0, (float)cell,
                      Model::kPieces);
        // In double: neighbours' corners meet as nearly as floats can
        Chart &c = model.charts[model.chartCount - 1];
        c.u = toFloat(u), c.v = toFloat(v), c.n = toFloat(n);
        c.width = (float)width, c.height = (float)tall;
        for (const Rectangle &r : rectangles)
            model.addFacet((float)(r.u0 - lo[0]), (float)(r.v0 - lo[1]), (float)(r.u1 - lo[0]),
                           (float)(r.v1 - lo[1]));
        if (rectangles.empty())
            for (int t : triangles) {
                float us[4], vs[4];
                for (size_t k = 0; k < 4; ++k) {
                    Vec2d f = place(mesh.triangles[(size_t)t].corners[std::min(k, (size_t)2)]);
                    us[k] = (float)(f[0] - lo[0]), vs[k] = (float)(f[1] - lo[1]);
                }
                model.addFacet(us, vs);
            }
        int material = mesh.triangles[(size_t)triangles[0]].material;
        c.material = (uint16_t)material;
        regions.material.push_back(material);
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

Regions addRegions(const Mesh &mesh, Model &model, double cell) {
    if (mesh.materials.size() > 65535) throw ModelError("a model may have 65535 materials at most");
    size_t count = mesh.triangles.size();
    std::vector<Vec3d> normals(count);
    for (size_t i = 0; i < count; ++i) normals[i] = normalize(normalOf(mesh, mesh.triangles[i]));
    double tiny = mesh.size() * 5e-6;
    auto joins = [&](int a, int b) {
        const Triangle &s = mesh.triangles[(size_t)a], &t = mesh.triangles[(size_t)b];
        if (s.material != t.material || dot(normals[(size_t)a], normals[(size_t)b]) < 0.999995) return false;
        for (int c : t.corners)
            if (std::fabs(dot(mesh.points[(size_t)c] - mesh.points[(size_t)s.corners[0]],
                              normals[(size_t)a])) > tiny)
                return false;
        return true;
    };

    // Grow regions over edges that two triangles share, turning the same way
    std::vector<Edge> edges = sortedEdges(mesh);
    Union sets(count);
    Regions regions;
    for (size_t i = 0; i < edges.size();) {
        size_t end = i + 1;
        while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
            ++end;
        bool pair = end == i + 2 && edges[i].forward != edges[i + 1].forward;
        if (pair) {
            int a = sets.root(edges[i].triangle), b = sets.root(edges[i + 1].triangle);
            // Against the region's first triangle: no drift along a bent surface
            if (a != b && joins(std::min(a, b), edges[i].triangle) &&
                joins(std::min(a, b), edges[i + 1].triangle))
                sets.parent[(size_t)std::max(a, b)] = std::min(a, b);
        }
        i = end;
    }

    // Gather their triangles and borders: edges that are not met in both directions
    std::vector<std::vector<int>> members(count);
    std::vector<std::vector<Edge>> borders(count);
    for (size_t i = 0; i < count; ++i) members[(size_t)sets.root((int)i)].push_back((int)i);
    for (size_t i = 0; i < edges.size(); ++i) {
        int root = sets.root(edges[i].triangle);
        bool inner = false;
        for (size_t k = i > 0 ? i - 1 : 0; k <= i + 1 && k < edges.size(); ++k)
            inner |= k != i && edges[k].low == edges[i].low && edges[k].high == edges[i].high &&
                     edges[k].forward != edges[i].forward && sets.root(edges[k].triangle) == root;
        if (!inner) borders[(size_t)root].push_back(edges[i]);
    }
    Builder builder = {mesh, model, regions, tiny, cell};
    for (size_t i = 0; i < count; ++i) {
        if (members[i].empty() || builder.add(members[i], borders[i])) continue;
        // Little of a rectangle: every triangle for itself
        for (int t : members[i]) {
            const auto &c = mesh.triangles[(size_t)t].corners;
            builder.add({t}, {{c[0], c[1], t, true}, {c[1], c[2], t, true}, {c[2], c[0], t, true}});
        }
    }
    return regions;
}

} // namespace odraz
