// Finds the sites near a point.
#pragma once

#include "tools/radiosity/rays/light_grid.h"
#include "trace/scene/bounds.h"

#include <algorithm>
#include <numeric>

namespace odraz::radiosity {

// A k-d tree of the sites. The root of a range of `order` is its middle item.
class NearSites {
public:
    explicit NearSites(const LightGrid &grid)
        : middles(grid.sites.size()), order(middles.size()), axes(middles.size()) {
        for (size_t i = 0; i < middles.size(); ++i) {
            const LightGrid::Site &s = grid.sites[i];
            for (uint32_t k = 0; k < s.pointCount; ++k) middles[i] += grid.points[s.firstPoint + k].p;
            middles[i] = middles[i] * (1 / (float)s.pointCount);
        }
        std::iota(order.begin(), order.end(), 0);
        sort(0, order.size());
    }

    Vec3 at(uint32_t site) const { return middles[site]; }
    // Calls visit(site, distance) for all sites within a radius.
    template <class Visit> void within(const Vec3 &p, float radius, const Visit &visit) const {
        search(0, order.size(), p, radius, visit);
    }

private:
    std::vector<Vec3> middles; // the centre of each site's sample points
    std::vector<uint32_t> order;
    std::vector<uint8_t> axes;
    static float component(const Vec3 &v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

    void sort(size_t first, size_t end) {
        while (end - first > 1) {
            Bounds box = kNoBounds;
            for (size_t i = first; i < end; ++i) include(box, {middles[order[i]], middles[order[i]]});
            Vec3 e = box.hi - box.lo;
            int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
            size_t middle = (first + end) / 2;
            auto at = [&](size_t i) { return order.begin() + (ptrdiff_t)i; };
            std::nth_element(at(first), at(middle), at(end), [&](uint32_t a, uint32_t b) {
                float x = component(middles[a], axis), y = component(middles[b], axis);
                return x != y ? x < y : a < b;
            });
            axes[middle] = (uint8_t)axis;
            sort(first, middle);
            first = middle + 1;
        }
    }

    template <class Visit>
    void search(size_t first, size_t end, const Vec3 &p, float radius, const Visit &visit) const {
        while (first < end) {
            size_t middle = (first + end) / 2;
            uint32_t site = order[middle];
            Vec3 d = middles[site] - p;
            if (float square = dot(d, d); square < radius * radius) visit(site, sqrt(square));
            float offset = component(d, axes[middle]); // from p to the dividing plane
            if (offset > -radius && offset < radius) {
                search(first, middle, p, radius, visit);
                first = middle + 1;
            } else if (offset >= 0)
                end = middle;
            else
                first = middle + 1;
        }
    }
};

} // namespace odraz::radiosity
