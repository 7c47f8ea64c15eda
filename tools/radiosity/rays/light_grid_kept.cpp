// The grid as arrays of a file.
#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/solve_task.h"

#include <algorithm>

namespace odraz::radiosity {

void LightGrid::save(std::string &to) const { put(to, cells, texels, siteOf, sites, places, tied, ring); }

LightGrid::LightGrid(Regions &regions, std::string_view from, size_t &at) : charts(regions.charts) {
    if (!get(from, at, cells, texels, siteOf, sites, places, tied, ring) || !fits(regions)) refuseResumed();
}

// Whether every index lies within its list. A checksum is not enough, because a forger can compute it.
bool LightGrid::fits(const Regions &regions) const {
    auto texelOf = [&](int chart, int t) {
        const Chart &c = charts[(size_t)chart];
        return t >= c.firstTexel && t < c.firstTexel + c.texels();
    };
    auto all = [](const auto &list, auto good) { return std::all_of(list.begin(), list.end(), good); };
    return validGeometry(charts, regions.facets, cells, texels) && siteOf.size() == texels.size() &&
           ring.size() == texels.size() &&
           all(charts,
               [&](const Chart &c) {
                   return c.firstTexel >= 0 && (size_t)c.firstTexel + (size_t)c.texels() <= texels.size();
               }) &&
           all(siteOf, [&](uint32_t s) { return s == kNone || s < sites.size(); }) &&
           all(sites,
               [&](const Site &s) {
                   return s.places >= 1 && s.places <= 16 &&
                          (size_t)s.firstPlace + s.places <= places.size() && s.chart >= 0 &&
                          (size_t)s.chart < charts.size();
               }) &&
           all(places, [&](const Place &p) { return p.texel >= 0 && (size_t)p.texel < texels.size(); }) &&
           all(tied, [&](int t) {
               return t >= 0 && (size_t)t < texels.size() && texelOf(texels[(size_t)t].chart, t);
           });
}

} // namespace odraz::radiosity
