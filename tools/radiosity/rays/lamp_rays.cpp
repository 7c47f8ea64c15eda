#include "tools/radiosity/rays/lamp_rays.h"

#include "base/maths.h"
#include "base/random.h"
#include "trace/shade/ball.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

namespace {

// If distance^2 / area is less, a disc is too coarse for a part, and for a whole lamp
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

// The light of suns and balls.
Rgb fromOutside(const Surroundings &around, const RayTree &tree, const Vec3 &p, const Vec3 &n,
                uint32_t seed) {
    Rgb sum = {};
    uint32_t state = pcg(seed);
    auto random = [&] { return unitFloat(state = pcg(state)); };
    for (const Sun &sun : around.suns) {
        float cosine = dot(sun.towards, n);
        if (cosine > 0 && !tree.blocked(p, sun.towards, kInfinity)) sum += sun.light * cosine;
    }
    for (const BallLamp &lamp : around.lamps) {
        Vec3 to = lamp.centre - p;
        float far = length(to);
        if (!(far > lamp.radius)) continue;
        float factor = ballFormFactor(broadcast(dot(to, n) / far),
                                      broadcast(lamp.radius * lamp.radius / (far * far)))[0];
        if (!(factor > 0)) continue;
        // Four points of the disc as which the ball is seen
        Vec3 side = normalize(cross(to, std::fabs(to.x) < std::fabs(to.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
             up = cross(to, side) * (1 / far);
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

// Near its side, a wall that touches the part hides it.
bool LampRays::Emitter::seen(const RayTree &tree, const Vec3 &p, float a, float b) const {
    Vec3 d = point(a, b) - p;
    if (a + b > 1) a = 1 - a, b = 1 - b; // as point() does
    float far = length(d);
    bool side = std::min(std::min(a, b), 1 - a - b) * least < far * 1.1e-4f;
    return far > 0 &&
           !tree.blocked(p, d * (1 / far), far * (side ? 1.000001f : 0.9999f), side ? &n : nullptr);
}

// The form factor of a part, without shadows. Beyond sqrt(near * area) the part counts as a disc.
float LampRays::formFactor(const Emitter &part, const Vec3 &p, const Vec3 &n, float near) {
    if (dot(p - part.corner[0], part.n) <= 0) return 0;
    Vec3 to = part.middle() - p;
    float square = dot(to, to);
    if (square > part.area * near) {
        // In the plane of the part, or of the place, only rounding errors remain
        float here = dot(to, n), there = -dot(to, part.n), least = 1e-6f * std::sqrt(square);
        return here > least && there > least ? here * there / square * part.area / (kPi * square + part.area)
                                             : 0;
    }
    // Clip the part at the horizon
    Vec3 corner[4];
    int corners = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = part.corner[k], &b = part.corner[(k + 1) % 3];
        float here = dot(a - p, n), there = dot(b - p, n);
        if (here > 0) corner[corners++] = a;
        if ((here > 0) != (there > 0)) corner[corners++] = a + (b - a) * (here / (here - there));
    }
    float factor = corners > 2 ? polygonFormFactor(p, n, corner, corners) : 0;
    return factor > 1e-7f ? factor : 0; // smaller values are rounding errors
}

Rgb LampRays::fromWholes(const RayTree &tree, const Vec3 *p, int places, const Vec3 &n, uint32_t seed,
                         int rays) const {
    float power[kMostWhole], factors[kMostWhole], sum = 0;
    for (size_t i = 0; i < wholes.size(); ++i) {
        float factor = 0;
        for (int k = 0; k < places; ++k) factor += formFactor(wholes[i], p[k], n, kNearWhole);
        factors[i] = factor / (float)places;
        sum += power[i] = wholes[i].power * factors[i];
    }
    Rgb all = {};
    for (size_t i = 0; i < wholes.size(); ++i) {
        Rgb light = wholes[i].radiance * factors[i];
        if (!(maxComponent(light) > 0)) continue;
        // Distribute the rays by light. Their targets are spread over the lamp (Roberts, 2018: the R2
        // sequence); their origins alternate between the places
        int own = std::max(1, (int)std::lround((float)rays * power[i] / sum));
        uint32_t state = pcg(seed + (uint32_t)i * 64);
        float a = unitFloat(state), b = unitFloat(pcg(state));
        float seen = 0, weights = 0;
        for (int k = 0; k < own; ++k) {
            const Vec3 &from = p[(seed + (uint32_t)k) % (uint32_t)places];
            Vec3 to = wholes[i].point(a, b) - from;
            float square = std::max(dot(to, to), 1e-30f);
            float weight =
                std::max(dot(to, n), 0.f) * std::max(-dot(to, wholes[i].n), 0.f) / (square * square);
            if (weights += weight; weight > 0 && wholes[i].seen(tree, from, a, b)) seen += weight;
            a = std::fmod(a + 0.7548777f, 1.f), b = std::fmod(b + 0.5698403f, 1.f);
        }
        if (seen > 0) all += light * (seen / weights);
    }
    return all;
}

Rgb LampRays::fromParts(const RayTree &tree, const Vec3 &p, const Vec3 &n, uint32_t seed, float shift,
                        int some) const {
    Rgb sum = {};
    uint32_t state = pcg(seed);
    auto random = [&] { return unitFloat(state = pcg(state)); };
    for (int k = 0; k < some; ++k) {
        float at = ((float)k + shift) / (float)some * until.back();
        auto i = std::min((size_t)(std::upper_bound(until.begin(), until.end(), at) - until.begin()),
                          parts.size() - 1);
        const Emitter &part = parts[i];
        float a = random(), b = random(), factor = formFactor(part, p, n, kNear);
        if (factor > 0 && maxComponent(part.radiance) > 0 && part.seen(tree, p, a, b))
            sum += part.radiance * (factor * until.back() / ((float)some * part.area * part.power));
    }
    return sum;
}

Rgb LampRays::at(const RayTree &tree, const Surroundings &around, const Vec3 *p, int places, const Vec3 &n,
                 uint32_t seed, float shift, int sharers) const {
    Rgb sum = {};
    int some = (std::min((int)parts.size(), kMost) + sharers - 1) / sharers;
    // Each lamp needs at least one ray: take all lamps only if that does not need many more rays
    bool all = !wholes.empty() && (int)wholes.size() <= std::max(kFew, 2 * some * places);
    for (int k = 0; k < places; ++k) {
        uint32_t own = seed * 4 + (uint32_t)k;
        if (!all && some > 0)
            sum += fromParts(tree, p[k], n, own, std::fmod(shift + (float)k / (float)sharers, 1.f), some);
        sum += fromOutside(around, tree, p[k], n, own);
    }
    sum = sum * (1 / (float)places);
    if (all) sum += fromWholes(tree, p, places, n, seed, some * places);
    return sum;
}

std::vector<Rgb> directLight(const LampRays &lamps, const Surroundings &around, const LightGrid &grid,
                             const std::vector<uint16_t> &excluded, const RayTree &tree, Workers &workers) {
    std::vector<Rgb> light(grid.texels.size());
    if (lamps.none() && around.suns.empty() && around.lamps.empty()) return light;
    parallelRanges(workers, (int)grid.sites.size(), 64, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const LightGrid::Site &s = grid.sites[(size_t)i];
            const Vec3 &n = grid.charts[(size_t)s.chart].n;
            auto counts = [&](uint32_t k) { return !(excluded[(size_t)i] >> k & 1); };
            auto texelOf = [&](uint32_t k) { return (size_t)grid.points[s.firstPoint + k].texel; };
            Rgb all = {};
            int places = 0, sharers = 0;
            for (uint32_t k = 0; k < s.pointCount; ++k) sharers += counts(k);
            float base = unitFloat(pcg((uint32_t)i));
            for (uint32_t k = 0, next; k < s.pointCount; k = next) {
                Vec3 at[4];
                int count = 0;
                for (next = k; next < s.pointCount && texelOf(next) == texelOf(k); ++next)
                    if (counts(next)) at[count++] = grid.points[s.firstPoint + next].p;
                if (!count) continue;
                float shift = base + (float)places / (float)sharers;
                light[texelOf(k)] =
                    lamps.at(tree, around, at, count, n, (uint32_t)texelOf(k), shift, sharers);
                all += light[texelOf(k)] * (float)count, places += count;
            }
            // Texels none of whose places count get the mean of the site
            for (uint32_t k = 0, next; k < s.pointCount; k = next) {
                int count = 0;
                for (next = k; next < s.pointCount && texelOf(next) == texelOf(k); ++next)
                    count += counts(next);
                if (!count) light[texelOf(k)] = all * (1 / (float)places);
            }
        }
    });
    return light;
}

} // namespace odraz::radiosity
