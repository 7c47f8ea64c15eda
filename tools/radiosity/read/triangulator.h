// Divides a polygon into triangles by cutting off its ears (Meisters, "Polygons Have Ears", 1975). The
// corners are projected along an axis and become whole numbers of 50 bits, so that every decision is exact
// and the same wherever the polygon lies. Holes may be joined to the outline by a bridge.
#pragma once

#include "tools/support/vec3d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace odraz::radiosity {

class Triangulator {
public:
    // Divides a polygon of at least three corners; neighbours must differ. Avoids triangles lower than
    // `least`. The time for N corners is about N log N.
    void divide(const std::vector<Vec3d> &corners, double least) {
        triangles.clear();
        crosses = false;
        if (corners.size() == 3) {
            triangles.push_back({0, 1, 2});
            return;
        }
        project(corners, least);
        if (corners.size() == 4 && divideQuad(corners)) return;
        linkCorners();
        crosses = turns() != 1 || crossesItself();
        findReflex();
        cutEars();
        flipFlat(corners, least);
    }

    std::vector<std::array<int, 3>> triangles; // indices of corners; all face the same way as the polygon
    bool crosses = false;                      // the polygon crosses itself

private:
    using Area = __int128;
    static constexpr int kBits = 50;         // per coordinate: differences of products fit into 128 bits
    static constexpr double kThinEar = 1e-4; // largest height of a thin ear, in lengths of its longest side

    struct Point {
        int64_t x, y;
        bool operator==(const Point &) const = default;
    };
    // Which corners may be cut off, best first: ears that are not thin, ears, corners without area, convex
    // corners, any. Only polygons that cross themselves need the last two.
    enum Choice { kGood, kThin, kFlat, kConvex, kAny };

    std::vector<Point> points;
    std::vector<int> before, after; // remaining neighbours; after -1: the corner is cut off
    int left = 0;                   // the number of remaining corners
    std::vector<int> reflex;        // corners that may lie in an ear, by cell of a grid
    std::vector<int> firstInCell;
    int64_t side = 1; // cells along each axis
    double thin = 0;  // narrower spikes count as having no area

    // Projects along the axis of the largest component of the polygon's area vector (Newell's). If its parts
    // face both ways and cancel out, the sums of their absolute components decide.
    void project(const std::vector<Vec3d> &corners, double least) {
        Vec3d area = {}, parts = {}, lo = corners[0], hi = lo;
        for (size_t i = 0; i < corners.size(); ++i) {
            const Vec3d &p = corners[i];
            Vec3d part = cross(p - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
            area = area + part;
            for (size_t k = 0; k < 3; ++k) {
                parts[k] += std::fabs(part[k]);
                lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
            }
        }
        const Vec3d &longest = length(area) > 1e-9 * length(parts) ? area : parts;
        size_t axis = 0;
        for (size_t k = 1; k < 3; ++k)
            if (std::fabs(longest[k]) > std::fabs(longest[axis])) axis = k;
        size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (area[axis] < 0) std::swap(u, v);
        int shift = kBits - 1 - std::ilogb(std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z}));
        thin = std::ldexp(least / 20, shift);
        points.clear();
        for (const Vec3d &p : corners)
            points.push_back({std::llround(std::ldexp(p[u] - lo[u], shift)),
                              std::llround(std::ldexp(p[v] - lo[v], shift))});
    }

    Area twiceArea(int a, int b, int c) const {
        const Point &p = points[(size_t)a], &q = points[(size_t)b], &r = points[(size_t)c];
        return (Area)(q.x - p.x) * (r.y - p.y) - (Area)(q.y - p.y) * (r.x - p.x);
    }

    // Divides along the shorter diagonal that lies inside; false if there is none.
    bool divideQuad(const std::vector<Vec3d> &corners) {
        bool first = twiceArea(0, 1, 2) > 0 && twiceArea(0, 2, 3) > 0,
             second = twiceArea(0, 1, 3) > 0 && twiceArea(1, 2, 3) > 0;
        if (!first && !second) return false;
        if (first && second) first = length(corners[2] - corners[0]) < length(corners[3] - corners[1]);
        triangles = first ? std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}
                          : std::vector<std::array<int, 3>>{{0, 1, 3}, {1, 2, 3}};
        return true;
    }

    void linkCorners() {
        const int count = left = (int)points.size();
        before.resize(points.size()), after.resize(points.size());
        for (int i = 0; i < count; ++i)
            before[(size_t)i] = (i + count - 1) % count, after[(size_t)i] = (i + 1) % count;
        for (int i = 0; i < count; ++i) cutSpikes(i);
    }

    void cutOff(int b) {
        int a = before[(size_t)b], c = after[(size_t)b];
        after[(size_t)a] = c, before[(size_t)c] = a, after[(size_t)b] = -1;
        --left;
    }

    // Whether the outline turns back at a corner, or repeats it: cutting it off loses no area.
    bool isSpike(int b) const {
        int a = before[(size_t)b], c = after[(size_t)b];
        if (left < 3 || c < 0) return false;
        const Point &p = points[(size_t)a], &q = points[(size_t)b], &r = points[(size_t)c];
        auto x0 = (double)(q.x - p.x), y0 = (double)(q.y - p.y), x1 = (double)(r.x - q.x),
             y1 = (double)(r.y - q.y);
        return x0 * x1 + y0 * y1 <= 0 && std::fabs((double)twiceArea(a, b, c)) <=
                                             thin * std::max(std::hypot(x0, y0), std::hypot(x1, y1));
    }

    // Cuts off a corner if it is a spike, then neighbours that become spikes.
    void cutSpikes(int b) {
        while (isSpike(b)) {
            int a = before[(size_t)b], c = after[(size_t)b];
            triangles.push_back({a, b, c}); // has an area in space if the polygon is not flat
            cutOff(b);
            b = isSpike(a) ? a : c;
        }
    }

    // The turning number of the outline: 1 for a simple counter-clockwise polygon.
    int turns() const {
        int sum = 0;
        auto up = [&](int a, int b) {
            const Point &p = points[(size_t)a], &q = points[(size_t)b];
            return q.y > p.y || (q.y == p.y && q.x > p.x);
        };
        for (int b = 0; b < (int)points.size(); ++b) {
            int a = before[(size_t)b], c = after[(size_t)b];
            if (c < 0 || up(a, b) == up(b, c)) continue;
            Area area = twiceArea(a, b, c);
            sum += (area > 0 && up(b, c)) - (area < 0 && up(a, b));
        }
        return sum;
    }

    // Whether two sides cross; sides that only touch, as at a bridge, do not.
    bool crossesItself() const {
        struct Side {
            int64_t left, right, low, high;
            int a, b;
        };
        std::vector<Side> sides;
        for (int a = 0; a < (int)points.size(); ++a) {
            int b = after[(size_t)a];
            if (b < 0) continue;
            auto [left, right] = std::minmax(points[(size_t)a].x, points[(size_t)b].x);
            auto [low, high] = std::minmax(points[(size_t)a].y, points[(size_t)b].y);
            sides.push_back({left, right, low, high, a, b});
        }
        std::sort(sides.begin(), sides.end(), [](const Side &s, const Side &t) { return s.left < t.left; });
        auto separates = [&](const Side &s, const Side &t) { // whether the ends of t lie on both sides of s
            Area first = twiceArea(s.a, s.b, t.a), second = twiceArea(s.a, s.b, t.b);
            return (first > 0 && second < 0) || (first < 0 && second > 0);
        };
        for (size_t i = 0; i < sides.size(); ++i)
            for (size_t k = i + 1; k < sides.size() && sides[k].left <= sides[i].right; ++k)
                if (sides[k].low <= sides[i].high && sides[i].low <= sides[k].high &&
                    separates(sides[i], sides[k]) && separates(sides[k], sides[i]))
                    return true;
        return false;
    }

    int64_t cellOf(int64_t x) const { return std::min(x * side >> kBits, side - 1); }

    // Sorts corners that are not convex into the cells of a grid.
    void findReflex() {
        const int count = (int)points.size();
        std::vector<int> all;
        for (int i = 0; i < count; ++i)
            if (after[(size_t)i] >= 0 && twiceArea(before[(size_t)i], i, after[(size_t)i]) <= 0)
                all.push_back(i);
        side = std::clamp((int64_t)std::sqrt((double)all.size()), (int64_t)1, (int64_t)4096);
        firstInCell.assign((size_t)(side * side) + 2, 0);
        auto cell = [&](int i) {
            return (size_t)(cellOf(points[(size_t)i].y) * side + cellOf(points[(size_t)i].x));
        };
        for (int i : all) ++firstInCell[cell(i) + 2];
        std::partial_sum(firstInCell.begin(), firstInCell.end(), firstInCell.begin());
        reflex.resize(all.size());
        for (int i : all) reflex[(size_t)firstInCell[cell(i) + 1]++] = i;
    }

    // Whether a remaining corner lies in the triangle a b c or on its border. A corner in the same place as
    // b, as at a bridge, does if one of its sides runs into the triangle.
    bool blocks(int reflex, int a, int b, int c) const {
        if (after[(size_t)reflex] < 0 || reflex == a || reflex == b || reflex == c) return false;
        const Point &p = points[(size_t)reflex];
        if (p == points[(size_t)a] || p == points[(size_t)c]) return false;
        if (p == points[(size_t)b]) {
            auto within = [&](int end) { return twiceArea(a, b, end) > 0 && twiceArea(b, c, end) > 0; };
            return within(before[(size_t)reflex]) || within(after[(size_t)reflex]);
        }
        return twiceArea(a, b, reflex) >= 0 && twiceArea(b, c, reflex) >= 0 && twiceArea(c, a, reflex) >= 0;
    }

    bool isEar(int b, Choice choice) const {
        int a = before[(size_t)b], c = after[(size_t)b];
        Area area = twiceArea(a, b, c);
        if (choice == kAny || (choice == kFlat && area == 0)) return true;
        if (area <= 0) return false;
        if (choice == kConvex) return true;
        const Point &p = points[(size_t)a], &q = points[(size_t)b], &r = points[(size_t)c];
        if (choice == kGood) {
            auto squared = [](const Point &s, const Point &t) {
                double x = (double)(t.x - s.x), y = (double)(t.y - s.y);
                return x * x + y * y;
            };
            if ((double)area < kThinEar * std::max({squared(p, q), squared(q, r), squared(r, p)}))
                return false;
        }
        auto [left, right] = std::minmax({p.x, q.x, r.x});
        auto [low, high] = std::minmax({p.y, q.y, r.y});
        for (int64_t y = cellOf(low); y <= cellOf(high); ++y) {
            auto from = (size_t)firstInCell[(size_t)(y * side + cellOf(left))],
                 end = (size_t)firstInCell[(size_t)(y * side + cellOf(right)) + 1];
            for (size_t i = from; i < end; ++i)
                if (blocks(reflex[i], a, b, c)) return false;
        }
        return true;
    }

    void cutEars() {
        const int count = (int)points.size();
        // Go round the outline: cutting one neighbour after another would make thin triangles
        std::vector<int> queue;
        size_t next = 0;
        bool found = true; // whether a corner was cut since the queue was filled
        for (int choice = kGood; left > 2;) {
            if (next == queue.size()) {
                if (!std::exchange(found, false)) ++choice;
                next = 0, queue.clear();
                for (int i = 0; i < count; ++i)
                    if (after[(size_t)i] >= 0) queue.push_back(i);
            }
            int b = queue[next++], a = before[(size_t)b], c = after[(size_t)b];
            if (c < 0 || !isEar(b, (Choice)choice)) continue;
            if (twiceArea(a, b, c) >= 0) triangles.push_back({a, b, c});
            if (choice >= kConvex) {
                crosses = true;
                if (count < 1000) choice = kThin;
            }
            cutOff(b);
            cutSpikes(a), cutSpikes(c);
            found = true;
            queue.push_back(a), queue.push_back(c);
        }
    }

    // Removes triangles lower than `least`: such a triangle and its neighbour at its longest side form a
    // quadrilateral, which is divided along its other diagonal instead.
    void flipFlat(const std::vector<Vec3d> &corners, double least) {
        constexpr size_t kMost = 1000; // the time grows with the square
        for (size_t i = 0; i < triangles.size() && triangles.size() < kMost; ++i) {
            auto &t = triangles[i];
            auto side = [&](size_t k) { return corners[(size_t)t[(k + 1) % 3]] - corners[(size_t)t[k]]; };
            size_t longest = 0;
            for (size_t k = 1; k < 3; ++k)
                if (length(side(k)) > length(side(longest))) longest = k;
            if (length(cross(side(0), side(1))) > least * length(side(longest))) continue;
            const int a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3];
            auto flip = [&] {
                for (auto &other : triangles)
                    for (size_t k = 0; k < 3; ++k) {
                        const int d = other[(k + 2) % 3];
                        if (other[k] != b || other[(k + 1) % 3] != a || twiceArea(a, d, c) <= 0 ||
                            twiceArea(d, b, c) <= 0)
                            continue;
                        t = {a, d, c}, other = {d, b, c};
                        return;
                    }
            };
            flip();
        }
    }
};

} // namespace odraz::radiosity
