#include "tools/radiosity/solution/solution.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace odraz::radiosity {

namespace {

// Whether a number is finite, and small enough that products of several are too.
bool moderate(float x) { return std::fabs(x) < 1e18f; }
bool moderate(const Vec3 &v) { return moderate(v.x) && moderate(v.y) && moderate(v.z); }
// Whether `count` items from `first` on lie within `all`
bool within(int first, int64_t count, size_t all) {
    return first >= 0 && count >= 0 && (int64_t)first + count <= (int64_t)all;
}

bool valid(const Chart &c, const Solution &b) {
    uint8_t open; // read as a byte: a bool other than 0 and 1 is undefined
    std::memcpy(&open, &c.open, 1);
    return moderate(c.corner) && moderate(c.u) && moderate(c.v) && moderate(c.n) && moderate(c.width) &&
           moderate(c.height) && c.width > 0 && c.height > 0 && open <= 1 && c.across > 0 && c.down > 0 &&
           within(c.firstCell, (int64_t)c.across * c.down, b.cells.size()) &&
           within(c.firstFacet, c.facetsCount, b.facets.size());
}

bool valid(const Facet &f, const Solution &b) {
    bool good = within(f.chart, 1, b.charts.size());
    for (int k = 0; k < 4; ++k) good &= moderate(f.u[k]) && moderate(f.v[k]);
    return good;
}

bool valid(const Cell &c, const Solution &b) {
    if (!within(c.chart, 1, b.charts.size()) || !moderate(c.area)) return false;
    for (int corner : c.corner)
        if (!within(corner, 1, b.texels.size()) || b.texels[(size_t)corner].chart != c.chart) return false;
    const Texel &low = b.texels[(size_t)c.corner[0]], &high = b.texels[(size_t)c.corner[3]];
    return low.x < high.x && low.y < high.y;
}

bool valid(const Texel &t, const Solution &b) {
    if (!within(t.chart, 1, b.charts.size())) return false;
    const Chart &c = b.charts[(size_t)t.chart];
    return t.x >= 0 && t.y >= 0 && t.x <= c.across && t.y <= c.down;
}

} // namespace

bool valid(const Solution &b) {
    auto all = [](const auto &list, auto good) { return std::all_of(list.begin(), list.end(), good); };
    auto finite = [&](const std::vector<Rgb> &list) {
        return all(list, [](const Rgb &c) { return moderate(c); });
    };
    return moderate(b.place) && !b.charts.empty() && b.light.size() == b.texels.size() &&
           b.reflects.size() == b.charts.size() && b.emits.size() == b.charts.size() && finite(b.light) &&
           finite(b.reflects) && finite(b.emits) && finite(b.cellReflects) &&
           (b.cellReflects.empty() || b.cellReflects.size() == b.cells.size()) &&
           all(b.charts, [&](const Chart &c) { return valid(c, b); }) &&
           all(b.facets, [&](const Facet &f) { return valid(f, b); }) &&
           all(b.texels, [&](const Texel &t) { return valid(t, b); }) &&
           all(b.cells, [&](const Cell &c) { return valid(c, b); });
}

} // namespace odraz::radiosity
