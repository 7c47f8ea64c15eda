#include "tools/radiosity/reference/obstacles.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

namespace {

// Distances with a smaller relative difference count as equal, as for the two sides of a sheet
constexpr double kSame = 1e-10;

struct Box {
    Vec3d lo = {INFINITY, INFINITY, INFINITY}, hi = lo * -1;

    void add(Vec3d p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    void add(const Box &b) { add(b.lo), add(b.hi); }
};

} // namespace

struct Obstacles::Builder {
    struct Item {
        Box box;
        Vec3d middle;
        int number;
    };
    const std::vector<Triangle> &triangles;
    Obstacles &tree;
    std::vector<Item> items = {};

    void build() {
        for (size_t i = 0; i < triangles.size(); ++i) {
            Box box;
            for (Vec3d p : triangles[i]) box.add(p);
            items.push_back({box, (box.lo + box.hi) * 0.5, (int)i});
        }
        tree.nodes.emplace_back();
        fill(0, 0, items.size());
    }
    // Makes a node of a range of triangles, whose children have a quarter of them each.
    void fill(size_t node, size_t begin, size_t end) {
        const size_t middle = divide(begin, end),
                     cuts[] = {begin, divide(begin, middle), middle, divide(middle, end), end};
        for (size_t k = 0; k < 4; ++k) {
            Box box;
            for (size_t i = cuts[k]; i < cuts[k + 1]; ++i) box.add(items[i].box);
            for (size_t axis = 0; axis < 3; ++axis) {
                tree.nodes[node].bound[0][axis][k] = box.lo[axis];
                tree.nodes[node].bound[1][axis][k] = box.hi[axis];
            }
            const int child = childOf(cuts[k], cuts[k + 1]); // may move the nodes
            tree.nodes[node].child[k] = child;
        }
    }
    int childOf(size_t begin, size_t end) {
        if (end - begin > 4) {
            size_t node = tree.nodes.size();
            tree.nodes.emplace_back();
            fill(node, begin, end);
            return (int)node;
        }
        Leaf leaf = {};
        for (size_t k = 0; k < 4; ++k) {
            leaf.number[k] = begin + k < end ? items[begin + k].number : -1;
            if (leaf.number[k] < 0) continue;
            for (size_t corner = 0; corner < 3; ++corner)
                for (size_t axis = 0; axis < 3; ++axis)
                    leaf.corner[corner][axis][k] = triangles[(size_t)leaf.number[k]][corner][axis];
        }
        tree.leaves.push_back(leaf);
        return ~(int)(tree.leaves.size() - 1);
    }
    // Sorts a range into halves along its longest axis. Returns the index of the second half.
    size_t divide(size_t begin, size_t end) {
        Box middles;
        for (size_t i = begin; i < end; ++i) middles.add(items[i].middle);
        const Vec3d size = middles.hi - middles.lo;
        const size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        auto at = [&](size_t i) { return items.begin() + (long)i; };
        std::nth_element(at(begin), at((begin + end) / 2), at(end),
                         [&](const Item &a, const Item &b) { return a.middle[axis] < b.middle[axis]; });
        return (begin + end) / 2;
    }
};

Obstacles::Obstacles(const std::vector<Triangle> &triangles) {
    if (!triangles.empty()) Builder{triangles, *this}.build();
}

// Visits leaves before `end`, nearest first, until visit(leaf) returns true. visit() may lower `end`.
template <class Visit> void Obstacles::walk(Vec3d o, Vec3d d, const double &end, Visit visit) const {
    if (nodes.empty()) return;
    double inverse[3];
    int nearSide[3];
    for (size_t axis = 0; axis < 3; ++axis) {
        inverse[axis] = 1 / std::copysign(std::max(std::fabs(d[axis]), 1e-200), d[axis]);
        nearSide[axis] = inverse[axis] < 0;
    }
    struct StackEntry {
        double from;
        int child;
    };
    StackEntry stack[256];
    int waiting = 0;
    stack[waiting++] = {0, 0};
    while (waiting > 0) {
        auto [from, child] = stack[--waiting];
        if (from > end * (1 + kSame)) continue;
        if (child < 0) {
            if (visit(leaves[(size_t)~child])) return;
            continue;
        }
        const Node &node = nodes[(size_t)child];
        Double4 enters = {}, leaves = {INFINITY, INFINITY, INFINITY, INFINITY};
        for (size_t axis = 0; axis < 3; ++axis) {
            Double4 in = (node.bound[nearSide[axis]][axis] - o[axis]) * inverse[axis],
                    out = (node.bound[1 - nearSide[axis]][axis] - o[axis]) * inverse[axis];
            enters = in > enters ? in : enters;
            leaves = out < leaves ? out : leaves;
        }
        int first = waiting;
        for (int k = 0; k < 4; ++k)
            if (enters[k] <= leaves[k] * (1 + kSame) && enters[k] <= end * (1 + kSame)) {
                int at = waiting++;
                for (; at > first && stack[at - 1].from < enters[k]; --at) stack[at] = stack[at - 1];
                stack[at] = {enters[k], node.child[k]};
            }
    }
}

// A ray's hits of the four triangles of a leaf.
struct Obstacles::LeafHits {
    Double4 t; // distances; infinity: no hit
    Mask4 back;
};

Obstacles::LeafHits Obstacles::intersect(const Leaf &leaf, Vec3d o, Vec3d d) {
    constexpr double kEdge = 1e-12; // tolerance: no ray passes between neighbours
    struct Vectors {
        Double4 x, y, z;
        Double4 times(const Vectors &b) const { return x * b.x + y * b.y + z * b.z; }
        Vectors cross(const Vectors &b) const {
            return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
        }
    };
    auto from = [&](int corner) {
        return Vectors{leaf.corner[corner][0] - leaf.corner[0][0], leaf.corner[corner][1] - leaf.corner[0][1],
                       leaf.corner[corner][2] - leaf.corner[0][2]};
    };
    constexpr Double4 kZero = {};
    Vectors ray = {kZero + d.x, kZero + d.y, kZero + d.z}, e1 = from(1), e2 = from(2), p = ray.cross(e2),
            s = {o.x - leaf.corner[0][0], o.y - leaf.corner[0][1], o.z - leaf.corner[0][2]}, q = s.cross(e1);
    Double4 determinant = e1.times(p), u = s.times(p) / determinant, v = ray.times(q) / determinant,
            t = e2.times(q) / determinant;
    // An unused triangle has determinant 0, so all comparisons fail
    Mask4 inside = (u >= -kEdge) & (v >= -kEdge) & (u + v <= 1 + kEdge) & (t > 0);
    return {inside ? t : kZero + INFINITY, determinant < 0};
}

Obstacles::Hit Obstacles::nearest(Vec3d o, Vec3d d) const {
    Hit hit;
    walk(o, d, hit.t, [&](const Leaf &leaf) {
        LeafHits met = intersect(leaf, o, d);
        for (int k = 0; k < 4; ++k) {
            double t = met.t[k];
            bool back = met.back[k] != 0;
            if (t < hit.t * (1 - kSame) || (t < hit.t * (1 + kSame) && hit.back && !back))
                hit = {t, leaf.number[k], back};
        }
        return false;
    });
    return hit;
}

bool Obstacles::blocked(Vec3d o, Vec3d d, double end) const {
    bool is = false;
    walk(o, d, end, [&](const Leaf &leaf) {
        LeafHits met = intersect(leaf, o, d);
        for (int k = 0; k < 4; ++k) is |= met.t[k] < end;
        return is;
    });
    return is;
}

} // namespace odraz::radiosity
