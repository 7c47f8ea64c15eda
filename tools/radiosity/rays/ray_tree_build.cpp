#include "tools/radiosity/rays/ray_tree.h"

#include "trace/scene/split.h"

#include <utility>

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
        int first, count;
        Bounds box;
    };
    static constexpr int kLeaf = 8;
    static constexpr int kSplit = 40; // down to this depth groups are halved by surface, below it by number

    Bounds boxOf(int first, int count) const {
        Bounds b = kNoBounds;
        for (int i = first; i < first + count; ++i) include(b, items[(size_t)i].box);
        return b;
    }

    int split(const Group &g, int deep) {
        return splitGroup(
            g.first, g.count, deep > kSplit, [&](int i) -> const Bounds & { return items[(size_t)i].box; },
            [&](int i, int k) { std::swap(items[(size_t)i], items[(size_t)k]); });
    }

    int leaf(const Group &g) {
        Leaf l = {};
        for (int k = 0; k < kLeaf; ++k) {
            l.number[k] = k < g.count ? items[(size_t)(g.first + k)].number : -1;
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
            int front = split(g, deep), rest = g.first + front;
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
    auto count = (int)triangles.size();
    b.build({0, count, b.boxOf(0, count)}, 0);
}

} // namespace odraz::radiosity
