// Splits a group of boxes in two, for building trees: by the surface area heuristic (Goldsmith and Salmon,
// 1987), evaluated over bins (Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", 2007).
#pragma once

#include "trace/scene/bounds.h"

namespace odraz {

inline float halfArea(const Bounds &b) {
    Vec3 e = b.hi - b.lo;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

inline float component(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

// Moves the items of the first part to the front of first .. first + count, and returns their number. If
// `halve` is set, or all boxes have the same centroid, the group is halved in its present order. box(i)
// returns the box of item i; swap(i, k) exchanges two items.
template <class Box, class Swap> int splitGroup(int first, int count, bool halve, Box &&box, Swap &&swap) {
    constexpr int kBins = 16;
    auto centroid = [&](int i) { return box(i).lo + box(i).hi; }; // doubled
    Bounds centroids = kNoBounds;
    for (int i = first; i < first + count; ++i) include(centroids, {centroid(i), centroid(i)});
    Vec3 extent = centroids.hi - centroids.lo;
    int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    float low = component(centroids.lo, axis), width = component(extent, axis);
    if (halve || !(width > 0)) return count / 2;

    Bounds boxes[kBins];
    int counts[kBins] = {};
    for (Bounds &b : boxes) b = kNoBounds;
    auto bin = [&](int i) {
        return min((int)((component(centroid(i), axis) - low) / width * kBins), kBins - 1);
    };
    for (int i = first; i < first + count; ++i) {
        include(boxes[bin(i)], box(i));
        ++counts[bin(i)];
    }
    // Sweep from both ends to find the split with the least sum of area times count
    float left[kBins];
    Bounds swept = kNoBounds;
    int passed = 0;
    for (int b = 0; b < kBins - 1; ++b) {
        include(swept, boxes[b]);
        left[b + 1] = halfArea(swept) * (float)(passed += counts[b]);
        if (!passed) left[b + 1] = kInfinity;
    }
    swept = kNoBounds;
    passed = 0;
    int best = 1;
    float least = kInfinity;
    for (int b = kBins - 1; b > 0; --b) {
        include(swept, boxes[b]);
        if (!(passed += counts[b])) continue;
        float cost = left[b] + halfArea(swept) * (float)passed;
        if (cost < least) {
            least = cost;
            best = b;
        }
    }
    int end = first;
    for (int i = first; i < first + count; ++i)
        if (bin(i) < best) swap(i, end++);
    int front = end - first;
    return front > 0 && front < count ? front : count / 2;
}

} // namespace odraz
