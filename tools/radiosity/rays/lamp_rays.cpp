#include "tools/radiosity/rays/lamp_rays.h"

#include "base/maths.h"
#include "base/random.h"
#include "tools/support/luminance.h"
#include "trace/shade/ball.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

// --- Parts of lamps ---

// Moves the bits of a number to every third position. Three such numbers make a Morton code: points that are
// close to each other have codes that are close.
static uint64_t everyThirdBit(uint32_t x) {
    uint64_t v = x & 0x1fffff;
    v = (v | v << 32) & 0x1f00000000ffff;
    v = (v | v << 16) & 0x1f0000ff0000ff;
    v = (v | v << 8) & 0x100f00f00f00f00f;
    v = (v | v << 4) & 0x10c30c30c30c30c3;
    return (v | v << 2) & 0x1249249249249249;
}

static Rgb emittedBy(const Mesh &mesh, const Triangle &t) {
    const auto &e = mesh.materials[(size_t)t.material].emits;
    return {e[0], e[1], e[2]};
}

LampRays::LampRays(const Mesh &mesh, const Regions &regions, int samples) {
    // Add up the area that emits, by chart and in total
    std::vector<double> areas(regions.charts.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        if (maxComponent(emittedBy(mesh, mesh.triangles[i])) > 0)
            areas[(size_t)regions.chartOf[i]] += length(normalOf(mesh, mesh.triangles[i])) / 2;
    double all = 0;
    for (double a : areas) all += a;
    emittingShare = all / std::max(areaOf(mesh), 1e-300);
    double largest = areas.empty() ? 0 : *std::max_element(areas.begin(), areas.end());
    for (const Triangle &t : mesh.triangles) brightest = std::max(brightest, luminance(emittedBy(mesh, t)));
    for (const Triangle &t : mesh.triangles)
        if (maxComponent(emittedBy(mesh, t)) > 0) divide(mesh, t, samples, largest);
    if (parts.empty()) return;
    if (wholes.size() > (size_t)kMostWhole) wholes.clear();
    sortParts(mesh);
}

// Divides a triangle into smaller ones of the same shape: about `samples` if its area is `largest`.
void LampRays::divide(const Mesh &mesh, const Triangle &t, int samples, double largest) {
    Rgb radiance = emittedBy(mesh, t);
    float power = brightest > 0 ? luminance(radiance) / brightest : 1;
    Vec3d normal = normalOf(mesh, t), q = mesh.points[(size_t)t.corners[0]],
          u = mesh.points[(size_t)t.corners[1]] - q, v = mesh.points[(size_t)t.corners[2]] - q;
    double area = length(normal) / 2;
    Vec3 n = toFloat(normalize(normal));
    auto height = (float)(2 * area / std::max({length(u), length(v), length(u - v)}));
    wholes.push_back({{toFloat(q), toFloat(q + u), toFloat(q + v)}, n, (float)area, radiance, power, height});
    int rows = std::clamp((int)std::lround(std::sqrt(samples * area / largest)), 1, 64);
    auto at = [&](int row, int step) {
        return toFloat(q + u * ((double)(row - step) / rows) + v * ((double)step / rows));
    };
    for (int r = 0; r < rows; ++r)
        for (int k = 0; k <= 2 * r; ++k) {
            int j = k / 2;
            Emitter p = {{at(r, j), at(r + 1, j), at(r + 1, j + 1)},
                         n,
                         (float)(area / (rows * rows)),
                         radiance,
                         power,
                         height / (float)rows};
            if (k & 1) p.corner[1] = at(r + 1, j + 1), p.corner[2] = at(r, j + 1);
            parts.push_back(p);
        }
}

// Sorts parts by their position in space, so that every n-th part is a selection spread over space.
void LampRays::sortParts(const Mesh &mesh) {
    Vec3d middle = mesh.middle();
    double size = std::max(mesh.size(), 1e-300);
    std::vector<std::pair<uint64_t, size_t>> order;
    for (size_t i = 0; i < parts.size(); ++i) {
        Vec3 c = parts[i].middle();
        auto step = [&](float x, double m) {
            return (uint32_t)std::clamp((((double)x - m) / size + 0.5) * 0x1fffff, 0., 2097151.);
        };
        order.push_back({everyThirdBit(step(c.x, middle.x)) | everyThirdBit(step(c.y, middle.y)) << 1 |
                             everyThirdBit(step(c.z, middle.z)) << 2,
                         i});
    }
    std::sort(order.begin(), order.end());
    std::vector<Emitter> sorted;
    double sum = 0;
    for (auto &[code, i] : order) {
        sorted.push_back(parts[i]);
        sum += (double)(parts[i].area * parts[i].power);
        sums.push_back((float)sum);
    }
    parts = std::move(sorted);
}

// --- Light ---

namespace {

// Beyond this distance^2 / area an emitter counts as a disc: for parts, and for whole triangles
constexpr float kNear = 16, kNearWhole = 400;

// Lambert's formula: a sum over the edges of a polygon.
float polygonFormFactor(const Vec3 &p, const Vec3 &n, const Vec3 *corner, int corners) {
    float sum = 0;
    for (int k = 0; k < corners; ++k) {
        Vec3 a = normalize(corner[k] - p), b = normalize(corner[(k + 1) % corners] - p), across = cross(b, a);
        float s = length(across);
        if (s > 1e-12f) sum += std::atan2(s, dot(a, b)) * dot(across, n) / s;
    }
    return std::max(sum, 0.f) * (0.5f / kPi);
}

Rgb fromSunsAndBalls(const Surroundings &surroundings, const RayTree &tree, const Vec3 &p, const Vec3 &n,
                     uint32_t seed) {
    Rgb sum = {};
    uint32_t state = pcg(seed);
    auto random = [&] { return unitFloat(state = pcg(state)); };
    for (const Sun &sun : surroundings.suns) {
        float cosine = dot(sun.towards, n);
        if (cosine > 0 && !tree.blocked(p, sun.towards, kInfinity)) sum += sun.light * cosine;
    }
    for (const BallLamp &lamp : surroundings.lamps) {
        Vec3 to = lamp.centre - p;
        float distance = length(to);
        if (!(distance > lamp.radius)) continue;
        float factor = ballFormFactor(broadcast(dot(to, n) / distance),
                                      broadcast(lamp.radius * lamp.radius / (distance * distance)))[0];
        if (!(factor > 0)) continue;
        // Cast rays to four points of the disc that the ball appears as
        Vec3 side = normalize(cross(to, std::fabs(to.x) < std::fabs(to.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
             up = cross(to, side) * (1 / distance);
        float turn = random() * 6.2831853f, open = 0;
        for (int k = 0; k < 4; ++k) {
            float r = lamp.radius * std::sqrt(((float)k + random()) / 4),
                  angle = turn + (float)k * 2.3999632f;
            Vec3 d = to + side * (r * std::cos(angle)) + up * (r * std::sin(angle));
            float l = length(d);
            open += tree.blocked(p, d * (1 / l), l) ? 0.f : 0.25f;
        }
        sum += lamp.radiance * (factor * open);
    }
    return sum;
}

} // namespace

// Near the emitter's sides the ray ends a little beyond the emitter, so that walls that touch it there block
// the ray.
bool LampRays::Emitter::visible(const RayTree &tree, const Vec3 &p, float a, float b) const {
    Vec3 d = point(a, b) - p;
    if (a + b > 1) a = 1 - a, b = 1 - b; // as point() does
    float distance = length(d);
    bool nearSide = std::min(std::min(a, b), 1 - a - b) * height < distance * 1.1e-4f;
    return distance > 0 && !tree.blocked(p, d * (1 / distance), distance * (nearSide ? 1.000001f : 0.9999f),
                                         nearSide ? &n : nullptr);
}

// The form factor of an emitter, without shadows. Beyond sqrt(near * area) it counts as a disc.
float LampRays::formFactor(const Emitter &e, const Vec3 &p, const Vec3 &n, float near) {
    if (dot(p - e.corner[0], e.n) <= 0) return 0;
    Vec3 to = e.middle() - p;
    float square = dot(to, to);
    if (square > e.area * near) {
        // In the plane of the emitter or of the receiver, only rounding errors remain
        float atReceiver = dot(to, n), atEmitter = -dot(to, e.n), least = 1e-6f * std::sqrt(square);
        if (!(atReceiver > least && atEmitter > least)) return 0;
        return atReceiver * atEmitter / square * e.area / (kPi * square + e.area);
    }
    // Clip the emitter at the horizon
    Vec3 corner[4];
    int corners = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = e.corner[k], &b = e.corner[(k + 1) % 3];
        float heightA = dot(a - p, n), heightB = dot(b - p, n);
        if (heightA > 0) corner[corners++] = a;
        if ((heightA > 0) != (heightB > 0)) corner[corners++] = a + (b - a) * (heightA / (heightA - heightB));
    }
    float factor = corners > 2 ? polygonFormFactor(p, n, corner, corners) : 0;
    return factor > 1e-7f ? factor : 0; // smaller values are rounding errors
}

Rgb LampRays::fromWholes(const RayTree &tree, const Receiver &r, int rays) const {
    float power[kMostWhole], factors[kMostWhole], sum = 0;
    for (size_t i = 0; i < wholes.size(); ++i) {
        float factor = 0;
        for (int k = 0; k < r.count; ++k) factor += formFactor(wholes[i], r.p[k], r.n, kNearWhole);
        factors[i] = factor / (float)r.count;
        sum += power[i] = wholes[i].power * factors[i];
    }
    Rgb all = {};
    for (size_t i = 0; i < wholes.size(); ++i) {
        Rgb light = wholes[i].radiance * factors[i];
        if (!(maxComponent(light) > 0)) continue;
        // Distribute the rays by light. Their targets are spread over the lamp (Roberts, 2018: the R2
        // sequence); their origins alternate between the points
        int count = std::max(1, (int)std::lround((float)rays * power[i] / sum));
        uint32_t state = pcg(r.seed + (uint32_t)i * 64);
        float a = unitFloat(state), b = unitFloat(pcg(state));
        float visible = 0, weights = 0;
        for (int k = 0; k < count; ++k) {
            const Vec3 &from = r.p[(r.seed + (uint32_t)k) % (uint32_t)r.count];
            Vec3 to = wholes[i].point(a, b) - from;
            float square = std::max(dot(to, to), 1e-30f);
            float weight =
                std::max(dot(to, r.n), 0.f) * std::max(-dot(to, wholes[i].n), 0.f) / (square * square);
            if (weights += weight; weight > 0 && wholes[i].visible(tree, from, a, b)) visible += weight;
            a = std::fmod(a + 0.7548777f, 1.f), b = std::fmod(b + 0.5698403f, 1.f);
        }
        if (visible > 0) all += light * (visible / weights);
    }
    return all;
}

Rgb LampRays::fromParts(const RayTree &tree, const Vec3 &p, const Vec3 &n, uint32_t seed, float shift,
                        int rays) const {
    Rgb sum = {};
    uint32_t state = pcg(seed);
    auto random = [&] { return unitFloat(state = pcg(state)); };
    for (int k = 0; k < rays; ++k) {
        float at = ((float)k + shift) / (float)rays * sums.back();
        auto i = std::min((size_t)(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin()),
                          parts.size() - 1);
        const Emitter &part = parts[i];
        float a = random(), b = random(), factor = formFactor(part, p, n, kNear);
        if (factor > 0 && maxComponent(part.radiance) > 0 && part.visible(tree, p, a, b))
            sum += part.radiance * (factor * sums.back() / ((float)rays * part.area * part.power));
    }
    return sum;
}

Rgb LampRays::at(const RayTree &tree, const Surroundings &surroundings, const Receiver &r) const {
    Rgb sum = {};
    int rays = (std::min((int)parts.size(), kMostRays) + r.sharers - 1) / r.sharers;
    // Each lamp needs at least one ray: use whole lamps only if that does not take many more rays
    bool whole = !wholes.empty() && (int)wholes.size() <= std::max(kFewLamps, 2 * rays * r.count);
    for (int k = 0; k < r.count; ++k) {
        uint32_t seed = r.seed * 4 + (uint32_t)k;
        float shift = std::fmod(r.shift + (float)k / (float)r.sharers, 1.f);
        if (!whole && rays > 0) sum += fromParts(tree, r.p[k], r.n, seed, shift, rays);
        sum += fromSunsAndBalls(surroundings, tree, r.p[k], r.n, seed);
    }
    sum = sum * (1 / (float)r.count);
    if (whole) sum += fromWholes(tree, r, rays * r.count);
    return sum;
}

std::vector<Rgb> directLight(const LampRays &lamps, const Surroundings &surroundings, const LightGrid &grid,
                             const std::vector<uint16_t> &excluded, Workers &workers) {
    std::vector<Rgb> light(grid.texels.size());
    if (lamps.none() && surroundings.suns.empty() && surroundings.lamps.empty()) return light;
    parallelRanges(workers, (int)grid.sites.size(), 64, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const LightGrid::Site &s = grid.sites[(size_t)i];
            LampRays::Receiver r = {{}, grid.charts[(size_t)s.chart].n, 0, 0, 0, 0};
            auto counts = [&](uint32_t k) { return !(excluded[(size_t)i] >> k & 1); };
            auto texelOf = [&](uint32_t k) { return (size_t)grid.points[s.firstPoint + k].texel; };
            for (uint32_t k = 0; k < s.pointCount; ++k) r.sharers += counts(k);
            Rgb all = {};
            int points = 0;
            std::vector<size_t> excludedTexels; // all of their points; they get the mean of the site
            float base = unitFloat(pcg((uint32_t)i));
            for (uint32_t k = 0, next; k < s.pointCount; k = next) {
                r.count = 0;
                for (next = k; next < s.pointCount && texelOf(next) == texelOf(k); ++next)
                    if (counts(next)) r.p[r.count++] = grid.points[s.firstPoint + next].p;
                if (!r.count) excludedTexels.push_back(texelOf(k));
                if (!r.count) continue;
                r.seed = (uint32_t)texelOf(k), r.shift = base + (float)points / (float)r.sharers;
                light[texelOf(k)] = lamps.at(grid.tree, surroundings, r);
                all += light[texelOf(k)] * (float)r.count, points += r.count;
            }
            for (size_t t : excludedTexels) light[t] = all * (1 / (float)points);
        }
    });
    return light;
}

} // namespace odraz::radiosity
