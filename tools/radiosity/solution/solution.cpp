#include "tools/radiosity/solution/solution.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/divide/facets.h"
#include "tools/radiosity/solution/arrays.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

// Whether a number is finite, and so small that products of several such numbers are finite too.
bool moderate(float x) { return std::fabs(x) < 1e18f; }
bool moderate(const Vec3 &v) { return moderate(v.x) && moderate(v.y) && moderate(v.z); }
// Whether `count` items from index `first` on lie within a list of `all`.
bool within(int first, int64_t count, size_t all) {
    return first >= 0 && count >= 0 && (int64_t)first + count <= (int64_t)all;
}

bool valid(const Chart &c, const Solution &b) {
    uint8_t open; // read as a byte: a bool other than 0 and 1 is undefined
    std::memcpy(&open, &c.open, 1);
    return moderate(c.corner) && moderate(c.u) && moderate(c.v) && moderate(c.n) && moderate(c.width) &&
           moderate(c.height) && c.width > 0 && c.height > 0 && open <= 1 && c.across > 0 && c.down > 0 &&
           within(c.firstCell, (int64_t)c.across * c.down, b.cells.size()) &&
           within(c.firstFacet, c.facetCount, b.facets.size());
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
    auto named = [&](const std::vector<int> &offsets) {
        return offsets.empty() ||
               (offsets.size() == b.charts.size() && !b.names.empty() && b.names.back() == 0 &&
                all(offsets, [&](int at) { return within(at, 1, b.names.size()); }));
    };
    return moderate(b.origin) && !b.charts.empty() && b.light.size() == b.texels.size() &&
           b.reflects.size() == b.charts.size() && b.emits.size() == b.charts.size() && finite(b.light) &&
           finite(b.reflects) && finite(b.emits) && finite(b.cellReflects) &&
           (b.cellReflects.empty() || b.cellReflects.size() == b.cells.size()) && named(b.material) &&
           named(b.object) && named(b.group) && all(b.charts, [&](const Chart &c) { return valid(c, b); }) &&
           all(b.facets, [&](const Facet &f) { return valid(f, b); }) &&
           all(b.texels, [&](const Texel &t) { return valid(t, b); }) &&
           all(b.cells, [&](const Cell &c) { return valid(c, b); });
}

void Solution::put(std::string &to) const {
    const std::vector<Vec3> origins = {origin};
    radiosity::put(to, origins, charts, facets, cells, texels, light, reflects, emits, cellReflects, material,
                   object, group, names);
}

bool Solution::get(const std::string &from, size_t &at) {
    std::vector<Vec3> origins;
    if (!radiosity::get(from, at, origins, charts, facets, cells, texels, light, reflects, emits,
                        cellReflects, material, object, group, names) ||
        origins.size() != 1)
        return false;
    origin = origins[0];
    return valid(*this);
}

void Solution::save(const std::string &path) const {
    if (!valid(*this))
        throw std::runtime_error(path + ": is not written: its numbers are too large for a solution");
    std::string body;
    put(body);
    common::writeWhole(path, withChecksum(kSolutionMagic, body));
}

Solution::Solution(const std::string &path) {
    std::string all = common::readWhole(path);
    size_t at = bodyOf(all, kSolutionMagic);
    if (!at) throw std::runtime_error(path + ": was not written by 'radiosity solve'");
    bool good = at != std::string::npos && get(all, at) && at == all.size();
    if (!good)
        throw std::runtime_error(path + ": is damaged, or from another version: solve the model again");
}

std::string Solution::nameOf(const std::vector<int> &offsets, int chart) const {
    std::string name = offsets.empty() ? "" : &names[(size_t)offsets[(size_t)chart]];
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < ' '; }, '?');
    return name;
}

Rgb Solution::reflectsOf(int cell) const {
    return cellReflects.empty() ? reflects[(size_t)cells[(size_t)cell].chart] : cellReflects[(size_t)cell];
}

Rgb Solution::bilinear(const std::vector<Rgb> &texelValues, int cell, float u, float v) const {
    // The position within the cell
    const Chart &c = charts[(size_t)cells[(size_t)cell].chart];
    const int *corner = cells[(size_t)cell].corner;
    const Texel &low = texels[(size_t)corner[0]], &high = texels[(size_t)corner[3]];
    auto share = [](float x, int low, int high) {
        return std::clamp((x - (float)low) / (float)(high - low), 0.f, 1.f);
    };
    float x = share(u / c.width * (float)c.across, low.x, high.x),
          y = share(v / c.height * (float)c.down, low.y, high.y);
    auto l = [&](int k) { return texelValues[(size_t)corner[k]]; };
    return lerp(lerp(l(0), l(1), x), lerp(l(2), l(3), x), y);
}

Rgb Solution::lightIn(int cell, float u, float v) const { return bilinear(light, cell, u, v); }

Rgb Solution::radiosityIn(int cell, float u, float v) const {
    Rgb all = lightIn(cell, u, v) * reflectsOf(cell) + emits[(size_t)cells[(size_t)cell].chart];
    return gloss.empty() ? all : all + bilinear(gloss, cell, u, v);
}

Solution::CellPoint Solution::cellPointAt(int chart, const Vec3 &p) const {
    const Chart &c = charts[(size_t)chart];
    float u = std::clamp(dot(p - c.corner, c.u), 0.f, c.width),
          v = std::clamp(dot(p - c.corner, c.v), 0.f, c.height);
    return {cellAt(c, {u, v}), u, v};
}

Rgb Solution::lightAt(int chart, const Vec3 &p) const {
    CellPoint s = cellPointAt(chart, p);
    return lightIn(s.cell, s.u, s.v);
}

Rgb Solution::radiosityAt(int chart, const Vec3 &p) const {
    CellPoint s = cellPointAt(chart, p);
    return radiosityIn(s.cell, s.u, s.v);
}

} // namespace odraz::radiosity
