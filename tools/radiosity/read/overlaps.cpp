#include "tools/radiosity/read/mesh_builder.h"

#include "tools/support/clip.h"

#include <algorithm>
#include <cmath>
#include <immintrin.h>
#include <map>
#include <ranges>

namespace odraz::radiosity {

namespace {

// Finds pairs of triangles that overlap.
class PairFinder {
public:
    PairFinder(const Mesh &mesh, const std::vector<int> &polygonOf, double tiny)
        : mesh(mesh), polygonOf(polygonOf), tiny(tiny) {
        boxes.reserve(mesh.triangles.size());
        for (const Triangle &t : mesh.triangles) {
            auto [p, q, r] = cornersOf(mesh, t);
            TriangleBox box = {{}, {}, (int)boxes.size()};
            for (size_t k = 0; k < 3; ++k) {
                auto [lo, hi] = std::minmax({p[k], q[k], r[k]});
                box.lo[k] = (float)(lo - tiny), box.hi[k] = (float)(hi + tiny);
            }
            boxes.push_back(box);
        }
    }

    // For each triangle that is partly covered: the triangles in front of it.
    std::map<int, std::set<int>> find() {
        find(boxes, 0);
        return std::move(found);
    }

private:
    struct TriangleBox {
        float lo[3], hi[3];
        int triangle;
    };
    const Mesh &mesh;
    const std::vector<int> &polygonOf;
    double tiny;
    std::vector<TriangleBox> boxes;
    std::map<int, std::set<int>> found;

    // Divides a set of triangles into two, until it is small or no axis separates them; triangles that cross
    // the middle are in both halves. Then tests all pairs.
    void find(std::vector<TriangleBox> &some, int depth) {
        constexpr size_t kSmall = 200;
        if (some.empty()) return;
        const std::array<size_t, 3> axes = axesOf(some);
        if (some.size() > kSmall && depth < 60)
            for (size_t axis : axes) {
                std::vector<float> middles;
                for (size_t i = 0; i < some.size(); i += 1 + some.size() / 100)
                    middles.push_back(some[i].lo[axis] + some[i].hi[axis]);
                auto middle = middles.begin() + (long)middles.size() / 2;
                std::nth_element(middles.begin(), middle, middles.end());
                const float at = *middle / 2;
                std::vector<TriangleBox> low, high;
                low.reserve(some.size()), high.reserve(some.size());
                for (const TriangleBox &b : some) {
                    if (b.lo[axis] <= at) low.push_back(b);
                    if (b.hi[axis] >= at) high.push_back(b);
                }
                if (low.size() + high.size() > some.size() * 5 / 4) continue;
                some = {};
                find(low, depth + 1), low = {};
                find(high, depth + 1);
                return;
            }
        const size_t axis = axes[0];
        std::sort(some.begin(), some.end(),
                  [&](const TriangleBox &s, const TriangleBox &t) { return s.lo[axis] < t.lo[axis]; });
        for (size_t i = 0; i < some.size(); ++i)
            for (size_t k = i + 1; k < some.size() && some[k].lo[axis] <= some[i].hi[axis]; ++k) {
                const TriangleBox &s = some[i], &t = some[k];
                if (s.lo[axes[1]] > t.hi[axes[1]] || t.lo[axes[1]] > s.hi[axes[1]] ||
                    s.lo[axes[2]] > t.hi[axes[2]] || t.lo[axes[2]] > s.hi[axes[2]])
                    continue;
                auto [front, behind] = std::minmax(s.triangle, t.triangle);
                if (overlap(front, behind)) found[behind].insert(front);
            }
    }

    std::array<size_t, 3> axesOf(const std::vector<TriangleBox> &some) const {
        __m128 lo = _mm_loadu_ps(some[0].lo), hi = _mm_loadu_ps(some[0].hi); // the fourth lane is ignored
        for (const TriangleBox &b : some)
            lo = _mm_min_ps(lo, _mm_loadu_ps(b.lo)), hi = _mm_max_ps(hi, _mm_loadu_ps(b.hi));
        float size[4];
        _mm_storeu_ps(size, _mm_sub_ps(hi, lo));
        std::array<size_t, 3> axes = {0, 1, 2};
        std::sort(axes.begin(), axes.end(), [&](size_t a, size_t b) { return size[a] > size[b]; });
        return axes;
    }

    bool overlap(int a, int b) const {
        if (polygonOf[(size_t)a] >= 0 && polygonOf[(size_t)a] == polygonOf[(size_t)b]) return false;
        Vec3d n = normalOf(mesh, mesh.triangles[(size_t)a]),
              other = normalOf(mesh, mesh.triangles[(size_t)b]);
        if (!(dot(n, other) > 0.9 * length(n) * length(other))) return false;
        if (dot(other, other) > dot(n, n)) std::swap(a, b), n = other; // use the larger one's plane
        n = normalize(n);
        const std::array<Vec3d, 3> p[2] = {cornersOf(mesh, mesh.triangles[(size_t)a]),
                                           cornersOf(mesh, mesh.triangles[(size_t)b])};
        for (const Vec3d &q : p[1])
            if (std::fabs(dot(q - p[0][0], n)) > tiny) return false;
        // They overlap unless a line along one of their sides separates them
        for (const auto &triangle : p)
            for (size_t k = 0; k < 3; ++k) {
                Vec3d out = normalize(cross(triangle[(k + 1) % 3] - triangle[k], n));
                double deepest = 0; // distance of the other's corners from this side, inwards
                for (const Vec3d &q : &triangle == p ? p[1] : p[0])
                    deepest = std::max(deepest, dot(triangle[k] - q, out));
                if (deepest <= 2 * tiny) return false;
            }
        return true;
    }
};

// A corner of a piece, and its texture coordinates.
struct PieceCorner {
    Vec3d p;
    double at[2];
};
using Piece = std::vector<PieceCorner>; // convex

// The part of a piece in front of the plane through `on` with normal `out`, if it extends more than `tiny`.
Piece inFront(const Piece &piece, const Vec3d &on, const Vec3d &out, double tiny) {
    auto distance = [&](const PieceCorner &c) {
        double d = dot(c.p - on, out);
        return std::fabs(d) <= tiny ? 0 : d;
    };
    if (std::none_of(piece.begin(), piece.end(), [&](const PieceCorner &c) { return distance(c) > 0; }))
        return {};
    return clip(piece, distance, [](const PieceCorner &a, const PieceCorner &b, double t) {
        return PieceCorner{a.p + (b.p - a.p) * t,
                           {a.at[0] + (b.at[0] - a.at[0]) * t, a.at[1] + (b.at[1] - a.at[1]) * t}};
    });
}

// Cuts covered parts out of triangles.
class OverlapCutter {
public:
    OverlapCutter(Mesh &mesh, std::vector<int> &polygonOf, double tiny)
        : mesh(mesh), polygonOf(polygonOf), tiny(tiny) {}

    std::set<PolygonPair> cut() {
        auto found = PairFinder(mesh, polygonOf, tiny).find();
        std::set<PolygonPair> pairs;
        if (found.empty()) return pairs;
        for (const auto &[behind, fronts] : found)
            for (int t : fronts) {
                pairs.insert({polygonOf[(size_t)t], polygonOf[(size_t)behind]});
                for (int c : mesh.triangles[(size_t)t].corners) point(mesh.points[(size_t)c], c);
                for (int c : mesh.triangles[(size_t)behind].corners) point(mesh.points[(size_t)c], c);
            }
        const std::vector<Triangle> triangles = std::move(mesh.triangles);
        const std::vector<std::array<float, 6>> coordinates = std::move(mesh.coordinates);
        const std::vector<int> polygons = std::move(polygonOf);
        mesh.triangles.clear(), mesh.coordinates.clear(), polygonOf.clear();
        for (size_t i = 0; i < triangles.size(); ++i) {
            auto fronts = found.find((int)i);
            const size_t before = mesh.triangles.size();
            if (fronts == found.end()) {
                mesh.triangles.push_back(triangles[i]);
                if (!coordinates.empty()) mesh.coordinates.push_back(coordinates[i]);
            } else
                addRest(triangles, fronts->second, triangles[i],
                        coordinates.empty() ? nullptr : coordinates[i].data());
            polygonOf.insert(polygonOf.end(), mesh.triangles.size() - before, polygons[i]);
        }
        return pairs;
    }

private:
    Mesh &mesh;
    std::vector<int> &polygonOf;
    double tiny;
    std::map<std::array<int64_t, 3>, int> pointAt; // by cell of a grid

    // The index of the point at p. If there is none yet, registers `number`, or adds a point if it is -1.
    int point(const Vec3d &p, int number = -1) {
        std::array<int64_t, 3> cell;
        for (size_t k = 0; k < 3; ++k) cell[k] = std::llround(p[k] / tiny);
        auto [entry, added] = pointAt.try_emplace(cell, number);
        if (added && number < 0) {
            entry->second = (int)mesh.points.size();
            mesh.points.push_back(p);
        }
        return entry->second;
    }

    // Adds the part of a triangle that no triangle in front covers.
    void addRest(const std::vector<Triangle> &triangles, const std::set<int> &fronts, const Triangle &t,
                 const float *at) {
        Piece whole;
        for (size_t k = 0; k < 3; ++k)
            whole.push_back({mesh.points[(size_t)t.corners[k]],
                             {at ? (double)at[2 * k] : 0, at ? (double)at[2 * k + 1] : 0}});
        const Vec3d n = normalize(normalOf(mesh, t));
        std::vector<Piece> rest = {whole}, left;
        for (int front : std::views::reverse(fronts)) { // the last one is likely to leave the fewest pieces
            if (rest.empty()) break;
            left.clear();
            for (const Piece &piece : rest) {
                Piece covered = piece;
                const size_t before = left.size();
                for (size_t k = 0; k < 3 && !covered.empty(); ++k) {
                    const auto &c = triangles[(size_t)front].corners;
                    const Vec3d &a = mesh.points[(size_t)c[k]], &b = mesh.points[(size_t)c[(k + 1) % 3]];
                    const Vec3d out = normalize(cross(b - a, n));
                    Piece outside = inFront(covered, a, out, tiny);
                    if (!outside.empty()) left.push_back(outside);
                    covered = inFront(covered, a, out * -1, tiny);
                }
                if (covered.empty()) left.resize(before), left.push_back(piece); // keep it whole
            }
            rest.swap(left);
        }
        for (const Piece &piece : rest)
            for (size_t k = 2; k < piece.size(); ++k) {
                const PieceCorner *corners[3] = {&piece[0], &piece[k - 1], &piece[k]};
                Triangle part = t;
                std::array<float, 6> uv;
                double longest = 0;
                for (size_t c = 0; c < 3; ++c) {
                    part.corners[c] = point(corners[c]->p);
                    uv[2 * c] = (float)corners[c]->at[0], uv[2 * c + 1] = (float)corners[c]->at[1];
                    longest = std::max(longest, length(corners[c]->p - corners[(c + 1) % 3]->p));
                }
                if (!(dot(normalOf(mesh, part), n) > longest * tiny)) continue;
                mesh.triangles.push_back(part);
                if (at) mesh.coordinates.push_back(uv);
            }
    }
};

} // namespace

std::set<PolygonPair> cutOverlaps(Mesh &mesh, std::vector<int> &polygonOf, double tiny) {
    return OverlapCutter(mesh, polygonOf, tiny).cut();
}

} // namespace odraz::radiosity
