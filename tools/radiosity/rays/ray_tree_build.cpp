#include "tools/radiosity/rays/ray_tree.h"

#include "trace/scene/bounds.h"

#include <algorithm>

namespace odraz::radiosity {

struct RayTree::Builder {
    const std::vector<Corners> &triangles;
    std::vector<Node> &nodes;
    std::vector<Leaf> &leaves;
    struct Item {
        Bounds box;
        int number;
    };
    std::vector<Item> items;

    struct Group {
        size_t first, count;
        Bounds box;
    };
    static constexpr size_t kLeaf = 8;
    static constexpr int kSplit = 40; // down to this depth groups are halved by surface, below it by number

    static float halfArea(const Bounds &b) {
        Vec3 e = b.hi - b.lo;
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
    static float at(const Vec3 &v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
    Bounds boxOf(size_t first, size_t count) const {
        Bounds b = kNoBounds;
        for (size_t i = first; i < first + count; ++i) include(b, items[i].box);
        return b;
    }

    // Sorts a group and returns the number of items in its first half. The division is the best by the
    // surface area heuristic over bins (Wald, 2007).
    size_t split(const Group &g, int deep) {
        constexpr int kBins = 16;
        auto middle = [&](const Item &i) { return i.box.lo + i.box.hi; };
        Bounds middles = kNoBounds;
        for (size_t i = g.first; i < g.first + g.count; ++i)
            include(middles, {middle(items[i]), middle(items[i])});
        Vec3 extent = middles.hi - middles.lo;
        int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        float low = at(middles.lo, axis), width = at(extent, axis);
        if (deep > kSplit || !(width > 0)) return g.count / 2;
        auto bin = [&](const Item &i) {
            return std::min((int)((at(middle(i), axis) - low) / width * kBins), kBins - 1);
        };
        Bounds boxes[kBins];
        size_t counts[kBins] = {};
        for (Bounds &b : boxes) b = kNoBounds;
        for (size_t i = g.first; i < g.first + g.count; ++i) {
            int k = bin(items[i]);
            include(boxes[k], items[i].box);
            ++counts[k];
        }
        float left[kBins];
        Bounds swept = kNoBounds;
        size_t passed = 0;
        for (int b = 0; b < kBins - 1; ++b) {
            include(swept, boxes[b]);
            passed += counts[b];
            left[b + 1] = passed ? halfArea(swept) * (float)passed : kInfinity;
        }
        swept = kNoBounds, passed = 0;
        int best = 1;
        float least = kInfinity;
        for (int b = kBins - 1; b > 0; --b) {
            include(swept, boxes[b]);
            if (!(passed += counts[b])) continue;
            float cost = left[b] + halfArea(swept) * (float)passed;
            if (cost < least) least = cost, best = b;
        }
        auto begin = items.begin() + (ptrdiff_t)g.first;
        auto end =
            std::partition(begin, begin + (ptrdiff_t)g.count, [&](const Item &i) { return bin(i) < best; });
        auto front = (size_t)(end - begin);
        return front > 0 && front < g.count ? front : g.count / 2;
    }

    int leaf(const Group &g) {
        Leaf l = {};
        for (size_t k = 0; k < kLeaf; ++k) {
            l.number[k] = k < g.count ? items[g.first + k].number : -1;
            if (k >= g.count) continue;
            const Corners &c = triangles[(size_t)l.number[k]];
            for (size_t i = 0; i < 3; ++i)
                l.corner[i][0][k] = c[i].x, l.corner[i][1][k] = c[i].y, l.corner[i][2][k] = c[i].z;
        }
        leaves.push_back(l);
        return ~(int)(leaves.size() - 1);
    }

    // Makes a node of a group: splits its largest part until there are eight parts.
    int build(const Group &all, int deep) {
        auto index = (int)nodes.size();
        nodes.emplace_back();
        Group parts[8] = {all};
        int count = 1;
        while (count < 8) {
            int largest = -1;
            float area = -1;
            for (int i = 0; i < count; ++i)
                if (float a = halfArea(parts[i].box); parts[i].count > kLeaf && a > area)
                    largest = i, area = a;
            if (largest < 0) break;
            Group &g = parts[largest];
            size_t front = split(g, deep);
            size_t rest = g.first + front;
            parts[count++] = {rest, g.count - front, boxOf(rest, g.count - front)};
            g = {g.first, front, boxOf(g.first, front)};
        }
        Node n;
        for (int i = 0; i < 8; ++i) {
            // Empty children lie infinitely far away
            Bounds b = {{kInfinity, kInfinity, kInfinity}, {kInfinity, kInfinity, kInfinity}};
            if (i < count) b = parts[i].box;
            n.lo[0][i] = b.lo.x, n.lo[1][i] = b.lo.y, n.lo[2][i] = b.lo.z;
            n.hi[0][i] = b.hi.x, n.hi[1][i] = b.hi.y, n.hi[2][i] = b.hi.z;
            n.child[i] = i >= count               ? -1
                         : parts[i].count > kLeaf ? build(parts[i], deep + 3)
                                                  : leaf(parts[i]);
        }
        nodes[(size_t)index] = n;
        return index;
    }
};

RayTree::RayTree(const std::vector<Corners> &triangles) {
    Builder b = {triangles, nodes, leaves, {}};
    b.items.resize(triangles.size());
    for (size_t i = 0; i < triangles.size(); ++i) {
        Bounds box = kNoBounds;
        for (const Vec3 &c : triangles[i]) include(box, {c, c});
        b.items[i] = {box, (int)i};
    }
    nodes.reserve(triangles.size() / 12 + 16), leaves.reserve(triangles.size() / 4 + 16);
    b.build({0, triangles.size(), b.boxOf(0, triangles.size())}, 0);
}

} // namespace odraz::radiosity
