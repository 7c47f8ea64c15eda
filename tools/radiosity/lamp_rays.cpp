#include "tools/radiosity/lamp_rays.h"

#include "base/maths.h"
#include "base/random.h"
#include "tools/radiosity/bright.h"
#include "trace/shade/ball.h"

#include <algorithm>
#include <cmath>

namespace odraz {

namespace {

// distance^2 over area within which a disc would not do for a part, and for all of a lamp
constexpr float kNear = 16, kNearWhole = 400;

// Lambert's formula, a sum over the edges of a polygon.
float polygonFormFactor(const Vec3 &p, const Vec3 &n, const Vec3 *corner, int corners) {
    float sum = 0;
    for (int k = 0; k < corners; ++k) {
        Vec3 a = normalize(corner[k] - p), b = normalize(corner[(k + 1) % corners] - p), across = cross(b, a);
        float s = length(across);
        if (s > 1e-12f) sum += std::atan2(s, dot(a, b)) * dot(across, n) / s;
    }
    return std::max(sum, 0.f) * (0.5f / kPi);
}

// A triangle as a disc; in its plane, or in the place's, there is nothing but rounding.
float discFormFactor(const Vec3 &to, float square, float area, const Vec3 &n, const Vec3 &its) {
    float here = dot(to, n), there = -dot(to, its), least = 1e-6f * std::sqrt(square);
    return here > least && there > least ? here * there / square * area / (kPi * square + area) : 0;
}

} // namespace

Rgb LampRays::unshadowed(const Vec3 &p, const Vec3 &n) const {
    Rgb sum = {};
    for (const Part &lamp : wholes) {
        if (dot(p - lamp.corner[0], lamp.n) <= 0) continue;
        Vec3 to = lamp.middle() - p;
        if (float square = dot(to, to); square > lamp.area * kNearWhole) {
            sum += lamp.radiance * discFormFactor(to, square, lamp.area, n, lamp.n);
            continue;
        }
        // What of it is above the horizon
        Vec3 corner[4];
        int corners = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 &a = lamp.corner[k], &b = lamp.corner[(k + 1) % 3];
            float here = dot(a - p, n), there = dot(b - p, n);
            if (here > 0) corner[corners++] = a;
            if ((here > 0) != (there > 0)) corner[corners++] = a + (b - a) * (here / (here - there));
        }
        if (corners > 2) sum += lamp.radiance * polygonFormFactor(p, n, corner, corners);
    }
    return sum;
}

LampRays::Light LampRays::from(const Part &part, const RayTree &tree, const Vec3 &p, const Vec3 &n, float a,
                               float b) const {
    if (dot(p - part.corner[0], part.n) <= 0) return {};
    if (a + b > 1) a = 1 - a, b = 1 - b;
    Vec3 target =
        part.corner[0] + (part.corner[1] - part.corner[0]) * a + (part.corner[2] - part.corner[0]) * b;
    Vec3 to = part.middle() - p;
    float square = dot(to, to), factor;
    if (square < part.area * kNear) {
        factor = polygonFormFactor(p, n, part.corner, 3);
        if (!(factor > 1e-7f)) return {}; // a rounding: in its plane nothing is seen of it
    } else {
        factor = discFormFactor(to, square, part.area, n, part.n);
        if (!(factor > 0)) return {};
    }
    Vec3 d = target - p;
    float far = length(d);
    Rgb light = part.radiance * factor;
    bool open = far > 0 && !tree.blocked(p, d * (1 / far), far * 0.9999f);
    return {light, open ? light : Rgb{}};
}

Rgb LampRays::at(const RayTree &tree, const Surroundings &around, const Vec3 &p, const Vec3 &n, uint32_t seed,
                 float shift, int sharers) const {
    Rgb sum = {}, all = {};
    uint32_t state = pcg(seed);
    auto random = [&] { return unitFloat(state = pcg(state)); };
    // From near every part counts; from afar some of them do, others from every place
    int some = (std::min((int)parts.size(), kMost) + sharers - 1) / sharers;
    bool every = (size_t)some >= parts.size();
    for (size_t i = 0; i < parts.size() && parts.size() <= (size_t)kMost && !every; ++i) {
        Vec3 to = parts[i].middle() - p;
        every = dot(to, to) < parts[i].area * kNear;
    }
    for (const Part &part : parts) {
        if (!every) break;
        float a = random(), b = random();
        Light light = from(part, tree, p, n, a, b);
        all += light.all, sum += light.open;
    }
    float power = parts.empty() ? 0 : until.back();
    for (int k = 0; k < some && !every; ++k) {
        float at = ((float)k + shift) / (float)some * power;
        auto i = std::min((size_t)(std::upper_bound(until.begin(), until.end(), at) - until.begin()),
                          parts.size() - 1);
        const Part &part = parts[i];
        float a = random(), b = random();
        Light light = from(part, tree, p, n, a, b);
        float share = power / ((float)some * part.area * bright(part.radiance));
        all += light.all * share, sum += light.open * share;
    }
    if (!wholes.empty() && maxComponent(sum) > 0) {
        Rgb whole = unshadowed(p, n);
        auto open = [](float part, float of) { return of > 0 ? part / of : 0; };
        sum = whole * Rgb{open(sum.x, all.x), open(sum.y, all.y), open(sum.z, all.z)};
    }
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
        // Four points of the disc that it shows
        Vec3 side = normalize(cross(to, std::fabs(to.x) < std::fabs(to.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
             up = cross(to, side) * (1 / far);
        float turn = random() * 6.2831853f, open = 0;
        for (int k = 0; k < 4; ++k) {
            float r = lamp.radius * std::sqrt(((float)k + random()) / 4),
                  angle = turn + (float)k * 2.3999632f;
            Vec3 d = to + side * (r * std::cos(angle)) + up * (r * std::sin(angle));
            float l = length(d);
            open += tree.blocked(p, d * (1 / l), l * 0.9999f) ? 0.f : 0.25f;
        }
        sum += lamp.radiance * (factor * open);
    }
    return sum;
}

std::vector<Rgb> directLight(const LampRays &lamps, const Surroundings &around, const LightGrid &grid,
                             const std::vector<uint16_t> &behind, const RayTree &tree, Workers &workers) {
    std::vector<Rgb> light(grid.texels.size());
    if (lamps.none() && around.suns.empty() && around.lamps.empty()) return light;
    parallelRanges(workers, (int)grid.sites.size(), 64, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const LightGrid::Site &s = grid.sites[(size_t)i];
            const Vec3 &n = grid.charts[(size_t)s.chart].n;
            auto counts = [&](uint32_t k) { return !(behind[(size_t)i] >> k & 1); };
            auto texelOf = [&](uint32_t k) { return (size_t)grid.places[s.firstPlace + k].texel; };
            Rgb all = {};
            int places = 0, sharers = 0;
            for (uint32_t k = 0; k < s.places; ++k) sharers += counts(k);
            float base = unitFloat(pcg((uint32_t)i));
            for (uint32_t k = 0, next; k < s.places; k = next) {
                Rgb sum = {};
                int count = 0;
                for (next = k; next < s.places && texelOf(next) == texelOf(k); ++next)
                    if (counts(next)) {
                        uint32_t place = s.firstPlace + next;
                        float shift = std::fmod(base + (float)places++ / (float)sharers, 1.f);
                        sum += lamps.at(tree, around, grid.places[place].p, n, place, shift, sharers);
                        ++count;
                    }
                all += sum;
                if (count) light[texelOf(k)] = sum * (1 / (float)count);
            }
            // Texels that have none are like the rest
            for (uint32_t k = 0, next; k < s.places; k = next) {
                int count = 0;
                for (next = k; next < s.places && texelOf(next) == texelOf(k); ++next) count += counts(next);
                if (!count) light[texelOf(k)] = all * (1 / (float)places);
            }
        }
    });
    return light;
}

} // namespace odraz
