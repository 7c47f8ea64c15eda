#include "tools/radiosity/rays/near_sites.h"

#include "trace/scene/bounds.h"

#include <numeric>

namespace odraz::radiosity {

NearSites::NearSites(const LightGrid &grid)
    : middles(grid.sites.size()), order(middles.size()), axes(middles.size()) {
    for (size_t i = 0; i < middles.size(); ++i) {
        const LightGrid::Site &s = grid.sites[i];
        for (uint32_t k = 0; k < s.places; ++k) middles[i] += grid.places[s.firstPlace + k].p;
        middles[i] = middles[i] * (1 / (float)s.places);
    }
    std::iota(order.begin(), order.end(), 0);
    sort(0, order.size());
}

void NearSites::sort(size_t first, size_t end) {
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

} // namespace odraz::radiosity
