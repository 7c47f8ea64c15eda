#include "tools/radiosity/rays/ray_system.h"

#include "base/random.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

namespace {

// `count` directions about z by the cosine law, sorted so that consecutive ones are close.
std::vector<Vec3> spiralOf(int count) {
    std::vector<Vec3> all;
    for (int i = 0; i < count; ++i) {
        double u = (i + 0.5) / count, r = std::sqrt(u), angle = i * 2.399963229728653;
        all.push_back({(float)(r * std::cos(angle)), (float)(r * std::sin(angle)), (float)std::sqrt(1 - u)});
    }
    // Sort by strips of the disc, in alternating direction
    auto strip = [&](const Vec3 &d) { return (int)((d.y + 1) * std::sqrt((float)count) / 4); };
    std::sort(all.begin(), all.end(), [&](const Vec3 &a, const Vec3 &b) {
        int s = strip(a), t = strip(b);
        return s != t ? s < t : s & 1 ? a.x > b.x : a.x < b.x;
    });
    return all;
}

__m128 toLanes(const Rgb &c) { return _mm_setr_ps(c.x, c.y, c.z, 0); }
Rgb toRgb(__m128 v) {
    alignas(16) float f[4];
    _mm_store_ps(f, v);
    return {f[0], f[1], f[2]};
}

} // namespace

RaySystem::RaySystem(const LightGrid &grid, const Surroundings &surroundings, Workers &workers)
    : near(grid), grid(grid), surroundings(surroundings), workers(workers) {
    size_t sites = grid.sites.size();
    firstOf.resize(sites + 1), found.resize(sites);
    arrives.resize(sites), sky.resize(sites), skySquare.resize(sites), reach.resize(sites),
        excluded.resize(sites);
}

size_t RaySystem::setRays(const std::vector<uint16_t> &counts) {
    std::vector<uint64_t> at(counts.size() + 1);
    for (size_t i = 0; i < counts.size(); ++i) at[i + 1] = at[i] + counts[i];
    std::vector<uint32_t> now(at.back(), kDark);
    size_t missing = 0;
    for (size_t i = 0; i < counts.size(); ++i) {
        size_t had = rays(i);
        found[i] = found[i] && had == counts[i];
        missing += !found[i];
        for (size_t k = 0; had && k < counts[i]; ++k) now[at[i] + k] = rows[firstOf[i] + k % had];
    }
    rows = std::move(now), firstOf = std::move(at);
    return missing;
}

std::string RaySystem::saved() const {
    std::string to;
    put(to, std::vector<uint8_t>{refined}, firstOf, rows, found, sky, skySquare, reach, excluded);
    return to;
}

bool RaySystem::restore(std::string_view from) {
    size_t count = grid.sites.size(), at = 0;
    std::vector<uint8_t> flag;
    if (!get(from, at, flag, firstOf, rows, found, sky, skySquare, reach, excluded) || at != from.size() ||
        flag.size() != 1 || firstOf.size() != count + 1 || firstOf[0] != 0 || firstOf[count] != rows.size() ||
        found.size() != count || sky.size() != count || skySquare.size() != count || reach.size() != count ||
        excluded.size() != count)
        return false;
    for (size_t i = 0; i < count; ++i)
        if (firstOf[i] >= firstOf[i + 1] || excluded[i] + 1 >= 1 << grid.sites[i].pointCount) return false;
    // The rows may have been found with a sky: clear its light
    if (!surroundings.sky.width)
        std::fill(sky.begin(), sky.end(), Rgb{}), std::fill(skySquare.begin(), skySquare.end(), 0.f);
    refined = flag[0];
    bool good = true;
    for (uint32_t k : rows) good &= (k < count) | (k == kDark);
    return good;
}

// Calls onHit(i, point, direction, hit) for every ray of a site; `point` is the index of its origin.
template <class OnHit>
void RaySystem::cast(size_t site, int count, const std::vector<Vec3> &spiral, const OnHit &onHit) const {
    const LightGrid::Site &s = grid.sites[site];
    const Chart &c = grid.charts[(size_t)s.chart];
    float turn = unitFloat(pcg((uint32_t)site * 2u + 1)) * 6.2831853f, sine = std::sin(turn),
          cosine = std::cos(turn);
    Vec3 u = c.u * cosine + c.v * sine, v = c.v * cosine - c.u * sine;
    uint32_t points[16], pointCount = 0;
    for (uint32_t k = 0; k < s.pointCount; ++k)
        if (!(excluded[site] >> k & 1)) points[pointCount++] = s.firstPoint + k;
    for (int i = 0; i < count; ++i) {
        const Vec3 &d = spiral[(size_t)i];
        uint32_t point = points[(uint32_t)i % pointCount];
        Vec3 direction = u * d.x + v * d.y + c.n * d.z;
        onHit(i, point, direction, grid.tree.nearest(grid.points[point].p, direction));
    }
}

uint32_t RaySystem::siteAt(int chart, const Vec3 &p, uint32_t random) const {
    LightGrid::Spot spot = grid.spotAt(chart, p);
    float weight[4], sum = grid.weigh(spot, weight);
    if (!(sum > 0)) return kDark;
    float at = unitFloat(random) * sum;
    int k = 0;
    for (; k < 3 && (at -= weight[k]) >= 0; ++k) {
    }
    while (!(weight[k] > 0)) k = (k + 3) % 4;
    return grid.siteOf[(size_t)spot.cell->corner[k]];
}

void RaySystem::findRow(size_t site, const std::vector<Vec3> &spiral) {
    uint32_t *row = &rows[firstOf[site]], first = grid.sites[site].firstPoint;
    auto count = (int)rays(site);
    Rgb open = {};
    float near = 0, squares = 0;
    int backs[16] = {}, all[16] = {};
    cast(site, count, spiral, [&](int i, uint32_t point, const Vec3 &d, const RayHit &hit) {
        row[i] = kDark;
        ++all[point - first];
        if (hit.triangle < 0) {
            Rgb light = surroundings.sky.width ? surroundings.sky.radiance(d) : Rgb{};
            open += light, squares += luminance(light) * luminance(light);
            return;
        }
        near += 1 / std::max(hit.t, 1e-30f);
        if (hit.back)
            ++backs[point - first];
        else
            row[i] = siteAt(grid.regions.chartOf[(size_t)hit.triangle], grid.points[point].p + d * hit.t,
                            pcg((uint32_t)(site * 8191 + (size_t)i)));
    });
    sky[site] = open * (1 / (float)count), skySquare[site] = squares / (float)count;
    reach[site] = near > 0 ? (float)count / near : kInfinity;
    // Exclude points that lie behind something, and find the row again
    if (excluded[site] || !findsExcluded) return;
    bool anyClear = false;
    uint16_t hidden = 0;
    for (int k = 0; k < grid.sites[site].pointCount; ++k) {
        anyClear |= backs[k] * 20 < all[k];
        if (backs[k] * 4 > all[k]) hidden |= (uint16_t)(1 << k);
    }
    if (!anyClear || !hidden) return;
    excluded[site] = hidden;
    findRow(site, spiral);
}

std::map<size_t, std::vector<Vec3>> RaySystem::spiralsOf(size_t first, size_t end) const {
    std::map<size_t, std::vector<Vec3>> all;
    for (size_t site = first; site < end; ++site)
        if (auto &spiral = all[rays(site)]; spiral.empty()) spiral = spiralOf((int)rays(site));
    return all;
}

void RaySystem::findRows(size_t first, size_t end) {
    const auto spirals = spiralsOf(first, end);
    parallelRanges(workers, (int)(end - first), 32, [&](int from, int to, int) {
        for (size_t site = first + (size_t)from; site < first + (size_t)to; ++site)
            if (!found[site]) findRow(site, spirals.at(rays(site)));
    });
    std::fill(found.begin() + (ptrdiff_t)first, found.begin() + (ptrdiff_t)end, true);
}

void RaySystem::alongOpenRays(const std::function<void(size_t, const Vec3 &)> &visit) const {
    const auto spirals = spiralsOf(0, found.size());
    parallelRanges(workers, (int)found.size(), 32, [&](int first, int end, int) {
        for (auto site = (size_t)first; site < (size_t)end; ++site) {
            auto row = rows.begin() + (ptrdiff_t)firstOf[site], last = row + (ptrdiff_t)rays(site);
            if (std::find(row, last, kDark) == last) continue; // no ray is open
            cast(site, (int)rays(site), spirals.at(rays(site)),
                 [&](int, uint32_t, const Vec3 &d, const RayHit &hit) {
                     if (hit.triangle < 0) visit(site, d);
                 });
        }
    });
}

// The light of the sky and, if these rays find it, of surfaces that emit.
std::vector<Rgb> RaySystem::sourceLight() const {
    std::vector<Rgb> light = sky;
    for (size_t i = 0; i < light.size() && !emits.empty(); ++i) {
        Rgb sum = {};
        for (uint64_t k = firstOf[i]; k < firstOf[i + 1]; ++k)
            if (rows[k] != kDark) sum += emitted(rows[k]);
        light[i] += sum * (1 / (float)rays(i));
    }
    return light;
}

// The light that arrives along a site's row. `radiosity` ends with a 0 for kDark.
Rgb RaySystem::gather(size_t site, const std::vector<Lanes> &radiosity) const {
    const uint32_t *row = &rows[firstOf[site]];
    size_t count = rays(site), k = 0;
    // Four sums, so that additions need not wait for each other
    __m128 sums[4] = {};
    auto add = [&](__m128 &sum, uint32_t from) {
        sum = _mm_add_ps(sum, radiosity[std::min((size_t)from, radiosity.size() - 1)].v);
    };
    for (; k + 4 <= count; k += 4)
        add(sums[0], row[k]), add(sums[1], row[k + 1]), add(sums[2], row[k + 2]), add(sums[3], row[k + 3]);
    for (; k < count; ++k) add(sums[0], row[k]);
    Rgb sum = toRgb(_mm_add_ps(_mm_add_ps(sums[0], sums[1]), _mm_add_ps(sums[2], sums[3])));
    return sum * (1 / (float)count);
}

int RaySystem::solve(const std::vector<Rgb> &direct, const std::vector<Rgb> &reflects, bool bounces,
                     float residual, int sweeps, const std::function<bool(float)> &afterSweep) {
    size_t count = grid.sites.size(), blocks = bounces ? 1 : std::clamp(count / 512, (size_t)1, (size_t)64);
    std::vector<Lanes> radiosity(count + 1), next(count); // the last one, for kDark, stays 0
    auto area = [&](size_t i) { return (double)grid.sites[i].size * (double)grid.sites[i].size; };
    const std::vector<Rgb> source = sourceLight();
    double initial = 0;
    for (size_t i = 0; i < count; ++i) {
        arrives[i] = source[i];
        Rgb b = reflects[i] * (direct[i] + source[i]);
        radiosity[i] = {toLanes(b)};
        initial += area(i) * (double)maxComponent(b);
    }
    std::vector<double> changes(count);
    int done = 0;
    for (bool on = initial > 0; on && done < sweeps;) {
        for (size_t b = 0; b < blocks; ++b) {
            size_t first = count * b / blocks, end = count * (b + 1) / blocks;
            parallelRanges(workers, (int)(end - first), 64, [&](int from, int to, int) {
                for (size_t i = first + (size_t)from; i < first + (size_t)to; ++i) {
                    arrives[i] = source[i] + gather(i, radiosity);
                    Rgb b = reflects[i] * (direct[i] + arrives[i]), d = b - toRgb(radiosity[i].v);
                    changes[i] = area(i) * (double)std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
                    next[i] = {toLanes(b)};
                }
            });
            std::copy(next.begin() + (ptrdiff_t)first, next.begin() + (ptrdiff_t)end,
                      radiosity.begin() + (ptrdiff_t)first);
        }
        ++done;
        double change = std::accumulate(changes.begin(), changes.end(), 0.);
        auto left = (float)(change / initial);
        on = afterSweep(left) && (bounces || left > residual);
    }
    return done;
}

void RaySystem::finalGather(int from, int to, int count, const Solution &soFar) {
    const std::vector<Vec3> spiral = spiralOf(count);
    parallelRanges(workers, to - from, 32, [&](int first, int end, int) {
        for (int site = from + first; site < from + end; ++site) {
            Rgb sum = {};
            cast((size_t)site, count, spiral, [&](int, uint32_t point, const Vec3 &d, const RayHit &hit) {
                if (hit.triangle < 0) {
                    if (surroundings.sky.width) sum += surroundings.sky.radiance(d);
                } else if (!hit.back) {
                    LightGrid::Spot s = grid.spotAt(grid.regions.chartOf[(size_t)hit.triangle],
                                                    grid.points[point].p + d * hit.t);
                    const int *c = s.cell->corner;
                    auto l = [&](int k) { return soFar.light[(size_t)c[k]]; };
                    sum += lerp(lerp(l(0), l(1), s.x), lerp(l(2), l(3), s.x), s.y) *
                           soFar.reflectsOf((int)(s.cell - grid.cells.data()));
                    if (!emits.empty()) sum += emits[(size_t)s.cell->chart];
                }
            });
            arrives[(size_t)site] = sum * (1 / (float)count);
        }
    });
}

} // namespace odraz::radiosity
