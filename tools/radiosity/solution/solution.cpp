#include "tools/radiosity/solution/solution.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/divide/facets.h"
#include "tools/radiosity/solution/arrays.h"

#include <algorithm>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

constexpr char kSolutionMagic[] = "odraz radiosity 4\n";

} // namespace

void Solution::put(std::string &to) const {
    const std::vector<Vec3> origin = {place};
    radiosity::put(to, origin, charts, facets, cells, texels, light, reflects, emits, cellReflects);
}

bool Solution::get(const std::string &from, size_t &at) {
    std::vector<Vec3> origin;
    if (!radiosity::get(from, at, origin, charts, facets, cells, texels, light, reflects, emits,
                        cellReflects) ||
        origin.size() != 1)
        return false;
    place = origin[0];
    return valid(*this);
}

void Solution::save(const std::string &path) const {
    if (!valid(*this))
        throw std::runtime_error(path + ": is not written: its numbers are too large for a solution");
    std::string body;
    put(body);
    common::writeWhole(path, withChecksum(body));
}

std::string Solution::withChecksum(const std::string &body) {
    return radiosity::withChecksum(kSolutionMagic, body);
}

Solution::Solution(const std::string &path) {
    std::string all = common::readWhole(path);
    size_t at = bodyOf(all, kSolutionMagic);
    if (!at) throw std::runtime_error(path + ": was not written by 'radiosity solve'");
    bool good = at != std::string::npos && get(all, at) && at == all.size();
    if (!good)
        throw std::runtime_error(path + ": is damaged, or from another version: solve the model again");
}

Rgb Solution::reflectsOf(int cell) const {
    return cellReflects.empty() ? reflects[(size_t)cells[(size_t)cell].chart] : cellReflects[(size_t)cell];
}

Rgb Solution::bilinear(const std::vector<Rgb> &of, int cell, float u, float v) const {
    // The position within the cell
    const Chart &c = charts[(size_t)cells[(size_t)cell].chart];
    const int *corner = cells[(size_t)cell].corner;
    const Texel &low = texels[(size_t)corner[0]], &high = texels[(size_t)corner[3]];
    auto share = [](float x, int low, int high) {
        return std::clamp((x - (float)low) / (float)(high - low), 0.f, 1.f);
    };
    float x = share(u / c.width * (float)c.across, low.x, high.x),
          y = share(v / c.height * (float)c.down, low.y, high.y);
    auto l = [&](int k) { return of[(size_t)corner[k]]; };
    return lerp(lerp(l(0), l(1), x), lerp(l(2), l(3), x), y);
}

Rgb Solution::lightIn(int cell, float u, float v) const { return bilinear(light, cell, u, v); }

Rgb Solution::radiosityIn(int cell, float u, float v) const {
    Rgb all = lightIn(cell, u, v) * reflectsOf(cell) + emits[(size_t)cells[(size_t)cell].chart];
    return gloss.empty() ? all : all + bilinear(gloss, cell, u, v);
}

Solution::Spot Solution::spotAt(int chart, const Vec3 &p) const {
    const Chart &c = charts[(size_t)chart];
    float u = std::clamp(dot(p - c.corner, c.u), 0.f, c.width),
          v = std::clamp(dot(p - c.corner, c.v), 0.f, c.height);
    return {cellAt(c, {u, v}), u, v};
}

Rgb Solution::lightAt(int chart, const Vec3 &p) const {
    Spot s = spotAt(chart, p);
    return lightIn(s.cell, s.u, s.v);
}

Rgb Solution::radiosityAt(int chart, const Vec3 &p) const {
    Spot s = spotAt(chart, p);
    return radiosityIn(s.cell, s.u, s.v);
}

} // namespace odraz::radiosity
