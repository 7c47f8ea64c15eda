#include "tools/radiosity/divide/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace odraz::radiosity {

namespace {

constexpr double kCoplanar = 0.999995; // normals count as parallel if their cosine is larger
constexpr size_t kBothSides = 4;       // number of triangles at an inner edge of a sheet lit from both sides

using Vec2d = std::array<double, 2>;

struct Rectangle {
    double u0, v0, u1, v1;
};

// The rectangles of a region; empty if some border runs neither along u nor along v. Divides the region into
// slabs at each v where a border along v ends. Lengths below `tiny` count as zero.
std::vector<Rectangle> rectanglesOf(const std::vector<std::array<Vec2d, 2>> &borders, double tiny) {
    struct Vertical {
        double u, v0, v1;
    };
    std::vector<Vertical> verticals;
    for (const auto &[a, b] : borders) {
        if (std::fabs(a[0] - b[0]) <= tiny)
            verticals.push_back({a[0], std::min(a[1], b[1]), std::max(a[1], b[1])});
        else if (std::fabs(a[1] - b[1]) > tiny)
            return {};
    }
    // Join adjacent pieces of a line
    std::sort(verticals.begin(), verticals.end(), [&](const Vertical &a, const Vertical &b) {
        return std::fabs(a.u - b.u) > tiny ? a.u < b.u : a.v0 < b.v0;
    });
    std::vector<Vertical> lines;
    for (const Vertical &s : verticals) {
        if (!lines.empty() && std::fabs(lines.back().u - s.u) <= tiny &&
            std::fabs(lines.back().v1 - s.v0) <= tiny)
            lines.back().v1 = s.v1;
        else
            lines.push_back(s);
    }
    std::vector<double> heights;
    for (const Vertical &s : lines) heights.push_back(s.v0), heights.push_back(s.v1);
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end(),
                              [&](double a, double b) { return std::fabs(a - b) <= tiny; }),
                  heights.end());
    std::vector<Rectangle> done, open;
    for (size_t i = 0; i + 1 < heights.size(); ++i) {
        double middle = (heights[i] + heights[i + 1]) / 2;
        std::vector<double> crossed;
        for (const Vertical &s : lines)
            if (s.v0 < middle && s.v1 > middle) crossed.push_back(s.u);
        if (crossed.size() % 2) return {};
        std::sort(crossed.begin(), crossed.end());
        std::vector<Rectangle> now;
        for (size_t k = 0; k < crossed.size(); k += 2)
            now.push_back({crossed[k], heights[i], crossed[k + 1], heights[i + 1]});
        // Extend a rectangle that continues upwards
        for (const Rectangle &was : open) {
            auto same = std::find_if(now.begin(), now.end(), [&](const Rectangle &r) {
                return std::fabs(r.u0 - was.u0) <= tiny && std::fabs(r.u1 - was.u1) <= tiny;
            });
            if (same == now.end())
                done.push_back(was);
            else
                same->v0 = was.v0;
        }
        open = now;
    }
    done.insert(done.end(), open.begin(), open.end());
    return done;
}

struct Edge {
    int low, high, triangle;
    bool forward; // from low to high
    auto operator<=>(const Edge &) const = default;
};

std::vector<Edge> sortedEdges(const Mesh &mesh) {
    std::vector<Edge> edges;
    edges.reserve(mesh.triangles.size() * 3);
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        for (size_t k = 0; k < 3; ++k) {
            int a = mesh.triangles[i].corners[k], b = mesh.triangles[i].corners[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), (int)i, a < b});
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

// Sets of triangles that can be joined (union-find).
struct Union {
    std::vector<int> parent;
    explicit Union(size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
    int root(int i) {
        while (parent[(size_t)i] != i) i = parent[(size_t)i] = parent[(size_t)parent[(size_t)i]];
        return i;
    }
};

// Turns sets of triangles that lie in one plane into charts.
struct ChartBuilder {
    const Mesh &mesh;
    Regions &regions;
    double tiny, cell;

    // Adds the triangles as one chart; false if they fill too little of its rectangle.
    bool add(std::span<const int> triangles, std::span<const Edge> borders) {
        PlaneFrame frame = frameOf(triangles, borders);
        Extent box = extentOf(triangles, frame);
        std::vector<Rectangle> rectangles;
        if (triangles.size() > 1) {
            std::vector<std::array<Vec2d, 2>> flat;
            for (const Edge &e : borders) flat.push_back({project(e.low, frame), project(e.high, frame)});
            rectangles = rectanglesOf(flat, std::min(tiny, 1e-4 * (box.width() + box.height())));
            if (rectangles.empty() && box.twiceArea < 0.6 * box.width() * box.height()) return false;
        }
        int material = mesh.triangles[(size_t)triangles[0]].material;
        Chart chart = chartOf(frame, box, material);
        addFacets(triangles, rectangles, frame, box);
        chart.facetCount = (int)regions.facets.size() - chart.firstFacet;
        for (int t : triangles) regions.chartOf[(size_t)t] = (int)regions.charts.size();
        regions.charts.push_back(chart);
        regions.deviation.push_back((float)box.deviation);
        regions.material.push_back(material);
        regions.object.push_back(mesh.triangles[(size_t)triangles[0]].object);
        return true;
    }

private:
    struct PlaneFrame {
        Vec3d origin, u, v, n;
    };
    struct Extent { // in a PlaneFrame
        Vec2d lo = {1e300, 1e300}, hi = {-1e300, -1e300};
        double twiceArea = 0; // twice the area of the triangles
        double deviation = 0; // the triangles' largest distance from the plane
        double width() const { return hi[0] - lo[0]; }
        double height() const { return hi[1] - lo[1]; }
    };

    // The plane's axes; u runs along the longest border.
    PlaneFrame frameOf(std::span<const int> triangles, std::span<const Edge> borders) const {
        Vec3d sum = {};
        for (int t : triangles) sum = sum + normalOf(mesh, mesh.triangles[(size_t)t]);
        Vec3d n = normalize(sum), along = {};
        const auto &points = mesh.points;
        for (const Edge &e : borders) {
            Vec3d side = points[(size_t)e.high] - points[(size_t)e.low];
            // Among borders of about equal length take the first, so that copies of a model are divided alike
            if (dot(side, side) > dot(along, along) * 1.0001) along = side;
        }
        along = along - n * dot(along, n);
        Vec3d u = normalize(along);
        return {points[(size_t)mesh.triangles[(size_t)triangles[0]].corners[0]], u, cross(n, u), n};
    }

    Vec2d project(int point, const PlaneFrame &frame) const {
        Vec3d d = mesh.points[(size_t)point] - frame.origin;
        return Vec2d{dot(d, frame.u), dot(d, frame.v)};
    }

    Extent extentOf(std::span<const int> triangles, const PlaneFrame &frame) const {
        Extent box;
        for (int t : triangles) {
            for (int c : mesh.triangles[(size_t)t].corners) {
                Vec2d p = project(c, frame);
                box.deviation =
                    std::max(box.deviation, std::fabs(dot(mesh.points[(size_t)c] - frame.origin, frame.n)));
                for (size_t k = 0; k < 2; ++k)
                    box.lo[k] = std::min(box.lo[k], p[k]), box.hi[k] = std::max(box.hi[k], p[k]);
            }
            box.twiceArea += length(normalOf(mesh, mesh.triangles[(size_t)t]));
        }
        return box;
    }

    Chart chartOf(const PlaneFrame &frame, const Extent &box, int material) const {
        auto cells = [&](double side) {
            return (int16_t)std::clamp((float)side / (float)cell + 0.5f, 1.f, (float)kMaxAcross);
        };
        Chart c = {};
        // Compute in double, so that the corners of neighbours agree as closely as floats allow
        c.corner = toFloat(frame.origin + (frame.u * box.lo[0] + frame.v * box.lo[1]));
        c.u = toFloat(frame.u), c.v = toFloat(frame.v), c.n = toFloat(frame.n);
        c.width = (float)box.width(), c.height = (float)box.height();
        c.across = cells(box.width()), c.down = cells(box.height());
        c.material = (uint16_t)material;
        c.firstFacet = (int)regions.facets.size();
        return c;
    }

    // Adds the rectangles as facets, or the triangles if there are no rectangles.
    void addFacets(std::span<const int> triangles, const std::vector<Rectangle> &rectangles,
                   const PlaneFrame &frame, const Extent &box) {
        auto add = [&](std::array<Vec2d, 4> corners) {
            Facet f = {(int)regions.charts.size(), {}, {}};
            for (size_t k = 0; k < 4; ++k)
                f.u[k] = (float)(corners[k][0] - box.lo[0]), f.v[k] = (float)(corners[k][1] - box.lo[1]);
            regions.facets.push_back(f);
        };
        for (const Rectangle &r : rectangles) add({{{r.u0, r.v0}, {r.u1, r.v0}, {r.u1, r.v1}, {r.u0, r.v1}}});
        if (!rectangles.empty()) return;
        for (int t : triangles) {
            const auto &c = mesh.triangles[(size_t)t].corners;
            Vec2d last = project(c[2], frame);
            add({project(c[0], frame), project(c[1], frame), last, last});
        }
    }
};

// Grows regions: sets of triangles of one object and material in one plane, joined across shared edges.
class RegionGrower {
public:
    explicit RegionGrower(const Mesh &mesh, double tiny)
        : mesh(mesh), tiny(tiny), normals(mesh.triangles.size()), edges(sortedEdges(mesh)),
          sets(mesh.triangles.size()) {
        for (size_t i = 0; i < normals.size(); ++i) normals[i] = normalize(normalOf(mesh, mesh.triangles[i]));
        for (size_t i = 0, end; i < edges.size(); i = end) {
            for (end = i + 1; end < edges.size() && sameEnds(edges[end], edges[i]);) ++end;
            joinOver({&edges[i], end - i});
        }
        for (size_t i = 0; i < normals.size(); ++i) roots.push_back(sets.root((int)i));
    }

    // The triangles of each set; sets are sorted by their first triangle.
    std::vector<std::vector<int>> members() const {
        std::vector<std::vector<int>> all(roots.size());
        for (size_t i = 0; i < roots.size(); ++i) all[(size_t)roots[i]].push_back((int)i);
        return all;
    }
    // The border of each set: its edges that do not occur in both directions.
    std::vector<std::vector<Edge>> borders() const {
        std::vector<std::vector<Edge>> all(roots.size());
        for (size_t i = 0; i < edges.size(); ++i)
            if (int set = borderOf(i); set >= 0) all[(size_t)set].push_back(edges[i]);
        return all;
    }

private:
    const Mesh &mesh;
    double tiny;
    std::vector<Vec3d> normals;
    std::vector<Edge> edges;
    Union sets;
    std::vector<int> roots;

    static bool sameEnds(const Edge &a, const Edge &b) { return a.low == b.low && a.high == b.high; }

    // Whether the triangles at an edge form one sheet: two triangles or, if both sides are lit, two fronts
    // and two backs.
    bool oneSheet(std::span<const Edge> all) const {
        if (all.size() == 2) return true;
        if (all.size() != kBothSides) return false;
        size_t fronts = 0;
        for (const Edge &e : all) {
            double cosine = dot(normals[(size_t)all[0].triangle], normals[(size_t)e.triangle]);
            if (std::fabs(cosine) < kCoplanar) return false;
            fronts += cosine > 0;
        }
        return fronts == kBothSides / 2;
    }

    // Whether triangle b has the object and material of triangle a and lies in its plane.
    bool joins(int a, int b) const {
        const Triangle &s = mesh.triangles[(size_t)a], &t = mesh.triangles[(size_t)b];
        if (s.material != t.material || s.object != t.object ||
            dot(normals[(size_t)a], normals[(size_t)b]) < kCoplanar)
            return false;
        const auto &points = mesh.points;
        Vec3d origin = points[(size_t)s.corners[0]], side = points[(size_t)s.corners[1]] - origin;
        double most = std::min(tiny * tiny, 1e-5 * dot(side, side));
        for (int c : t.corners)
            if (double off = dot(points[(size_t)c] - origin, normals[(size_t)a]); off * off > most)
                return false;
        return true;
    }

    // Joins triangles that share an edge and have the same orientation.
    void joinOver(std::span<const Edge> all) {
        if (!oneSheet(all)) return;
        for (size_t k = 0; k + 1 < all.size(); ++k)
            for (size_t l = k + 1; l < all.size(); ++l) {
                int s = all[k].triangle, t = all[l].triangle, a = sets.root(s), b = sets.root(t);
                // Compare both with the region's first triangle, or regions would follow curved surfaces
                if (all[k].forward != all[l].forward && a != b && joins(std::min(a, b), s) &&
                    joins(std::min(a, b), t))
                    sets.parent[(size_t)std::max(a, b)] = std::min(a, b);
            }
    }

    // The region on whose border edge i lies, or -1.
    int borderOf(size_t i) const {
        int root = roots[(size_t)edges[i].triangle];
        for (size_t k = i - std::min(i, kBothSides - 1); k < std::min(i + kBothSides, edges.size()); ++k)
            if (k != i && sameEnds(edges[k], edges[i]) && edges[k].forward != edges[i].forward &&
                roots[(size_t)edges[k].triangle] == root)
                return -1;
        return root;
    }
};

} // namespace

Regions joinRegions(const Mesh &mesh, double cell) {
    if (mesh.materials.size() > 65535) throw ModelError("a model may have 65535 materials at most");
    size_t count = mesh.triangles.size();
    Regions regions;
    const double tiny = mesh.size() * 5e-6;
    regions.chartOf.resize(count);
    RegionGrower grower(mesh, tiny);
    const auto members = grower.members();
    const auto borders = grower.borders();
    ChartBuilder builder = {mesh, regions, tiny, cell};
    for (size_t i = 0; i < count; ++i) {
        if (members[i].empty() || builder.add(members[i], borders[i])) continue;
        // The region fills too little of its rectangle: make a chart of each triangle
        for (int t : members[i]) {
            const auto &c = mesh.triangles[(size_t)t].corners;
            const Edge sides[] = {{c[0], c[1], t, true}, {c[1], c[2], t, true}, {c[2], c[0], t, true}};
            builder.add({&t, 1}, sides);
        }
    }
    return regions;
}

void fillModel(Model &model, const Regions &regions) {
    if (regions.charts.size() > (size_t)kMaxCharts || regions.facets.size() > (size_t)kMaxFacets)
        throw ModelError("more than " + std::to_string(kMaxFacets) +
                         " polygons are left after joining those in one plane: solve by rays, without "
                         "--hemicube, --patch and --direct");
    std::copy(regions.charts.begin(), regions.charts.end(), model.charts);
    std::copy(regions.facets.begin(), regions.facets.end(), model.facets);
    model.chartCount = (int)regions.charts.size(), model.facetCount = (int)regions.facets.size();
}

} // namespace odraz::radiosity
