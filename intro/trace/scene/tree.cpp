#include "trace/scene/tree.h"

#include "trace/scene/scene.h"
#include "trace/scene/split.h"

namespace odraz {

namespace {

// The shapes order[first .. first + count) and their box.
struct ShapeRange {
    int first, count;
    Bounds box;
};

Bounds boxOf(const Scene &s, int first, int count) {
    Bounds b = kNoBounds;
    for (int i = first; i < first + count; ++i) include(b, s.box[s.order[i]]);
    return b;
}

int split(Scene &s, const ShapeRange &g, bool halve) {
    return splitGroup(
        g.first, g.count, halve, [&](int i) -> const Bounds & { return s.box[s.order[i]]; },
        [&](int i, int k) {
            uint16_t moved = s.order[i];
            s.order[i] = s.order[k];
            s.order[k] = moved;
        });
}

// Builds the node of a range of shapes and the nodes below it. Returns the node's index. Splits the range,
// and then always its largest part, until there are eight parts.
int build(Scene &s, const ShapeRange &all, int depth) {
    int index = s.nodeCount++;
    ShapeRange parts[8] = {all};
    int count = 1;
    while (count < 8) {
        // Find the part with the largest surface. A part of at most eight shapes is not split here, but
        // becomes a node, which splits it into single shapes
        int largest = -1;
        float area = -1;
        for (int i = 0; i < count; ++i) {
            float a = halfArea(parts[i].box);
            if (parts[i].count <= (all.count <= 8 ? 1 : 8) || a <= area) continue;
            largest = i;
            area = a;
        }
        if (largest < 0) break;
        ShapeRange &g = parts[largest];
        int front = split(s, g, depth > kTreeDepth / 2);
        parts[count++] = {g.first + front, g.count - front, boxOf(s, g.first + front, g.count - front)};
        g = {g.first, front, boxOf(s, g.first, front)};
    }

    Node &n = s.nodes[index];
    n.count = count;
    n.balls = true;
    for (int i = 0; i < count; ++i)
        n.balls &= parts[i].count == 1 && s.shapes[s.order[parts[i].first]].isBall();
    for (int i = 0; i < 8; ++i) {
        const ShapeRange &g = parts[min(i, count - 1)];
        const Shape &shape = s.shapes[s.order[g.first]];
        // Grow boxes by the slab test's rounding error; the boxes of missing children are never entered
        Vec3 size = upper(g.box.hi, -g.box.lo);
        Vec3 margin = size * 4e-6f + Vec3{1e-7f, 1e-7f, 1e-7f};
        Vec3 lo = n.balls ? shape.centre : g.box.lo - margin, hi = g.box.hi + margin;
        if (i >= count) lo = {kInfinity, kInfinity, kInfinity}, hi = -lo;
        n.lo[0][i] = lo.x, n.lo[1][i] = lo.y, n.lo[2][i] = lo.z;
        n.hi[0][i] = hi.x, n.hi[1][i] = hi.y, n.hi[2][i] = hi.z;
        if (n.balls) n.radius[i] = i < count ? shape.half.x : 0;
        n.child[i] = ~s.order[g.first];
    }
    for (int i = 0; i < count; ++i)
        if (parts[i].count > 1) {
            int child = build(s, parts[i], depth + 1);
            s.nodes[index].child[i] = child;
        }
    return index;
}

} // namespace

void buildTree(Scene &s, int bounded) {
    s.nodeCount = 0;
    if (bounded) build(s, {0, bounded, boxOf(s, 0, bounded)}, 0);
}

} // namespace odraz
