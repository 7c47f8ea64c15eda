#include "tools/measure/reference/hall_paths.h"

#include "show/hall_model.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odraz::measure {

using namespace radiosity;

namespace {

// A sky as a picture of all directions, without the glow that counts as part of the sun.
SkyPicture pictureOf(Sky sky) {
    sky.near = {};
    constexpr int kHeight = 128;
    SkyPicture picture = {2 * kHeight, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < 2 * kHeight; x += 8) {
            Vec3x8 d;
            for (int k = 0; k < 8; ++k) {
                double theta = (y + 0.5) / kHeight * std::numbers::pi,
                       phi = ((x + k + 0.5) / kHeight - 1) * std::numbers::pi;
                d.x[k] = (float)(std::sin(theta) * std::sin(phi)), d.y[k] = (float)std::cos(theta);
                d.z[k] = (float)(-std::sin(theta) * std::cos(phi));
            }
            Rgb8 light = radiance(sky, d);
            for (int k = 0; k < 8; ++k) picture.pixels.push_back({light.x[k], light.y[k], light.z[k]});
        }
    return picture;
}

LightOfHall day(const char *name, float hour) {
    Daylight now = daylightAt(hour);
    return {name,
            lightVector({hour, {}, {}, 1}),
            {pictureOf(now.sky), {{normalize(now.sunAt), now.sunlight}}, {}},
            0,
            true};
}

// The hall as triangles, each in the material of its chart.
Mesh meshOf(const Model &m, const Scene &scene, float strips) {
    Mesh mesh;
    for (int i = 0; i < kHallMaterials; ++i) {
        Rgb rho = scene.mean[i];
        float e = i >= kStrip ? strips : 0;
        mesh.materials.push_back({"", {rho.x, rho.y, rho.z}, {e, e, e}});
    }
    for (int i = 0; i < m.facetCount; ++i) {
        const Chart &c = m.charts[m.facets[i].chart];
        if (c.open) continue;
        int first = (int)mesh.points.size();
        for (int k = 0; k < 4; ++k) mesh.points.push_back(toDouble(m.facets[i].corner(c, k)));
        mesh.triangles.push_back({{first, first + 1, first + 2}, c.material});
        mesh.triangles.push_back({{first, first + 2, first + 3}, c.material});
    }
    return mesh;
}

float valueAt(const float *plane, const Chart &c, const std::array<float, 2> &at) {
    float x = at[0] / c.width * (float)c.across, y = at[1] / c.height * (float)c.down;
    int i = std::min((int)x, c.across - 1), j = std::min((int)y, c.down - 1);
    x -= (float)i, y -= (float)j;
    const float *p = plane + c.texel(i, j), *q = p + c.across + 1;
    return std::lerp(std::lerp(p[0], p[1], x), std::lerp(q[0], q[1], x), y);
}

} // namespace

std::vector<LightOfHall> lightsOf(const Hall &hall) {
    std::vector<LightOfHall> all = {day("noon", kNoon), day("evening", kEvening)};
    LightOfHall lanterns = {"lanterns", {}, {}, 0, false}, strips = {"strips", {}, {}, 1, false};
    for (int k = kFirstLantern; k < kFirstStrip; ++k) {
        lanterns.relit.bounced[k] = lanterns.relit.direct[k] = {1, 1, 1};
        lanterns.around.lamps.push_back(
            {hall.radiosity.bases.lamps[k - kFirstLantern].centre, kLanternRadius, {1, 1, 1}});
    }
    for (int k = kFirstStrip; k < kFirstStrip + kStrips; ++k)
        strips.relit.bounced[k] = strips.relit.direct[k] = {1, 1, 1};
    all.push_back(lanterns), all.push_back(strips);
    // The point of scene 5, half-way between two lanterns
    constexpr float kRadius = 0.06f;
    HallLight light = {kNight, {}, {}, 0, 0, {{0, 1.4f, 0.5f * kLanternSpacing}, {1, 1, 1}, kRadius}};
    float radiance = 1 / (kRadius * kRadius);
    all.push_back({"the point",
                   lightVector(light),
                   {{}, {}, {{light.extra.position, kRadius, {radiance, radiance, radiance}}}},
                   0,
                   true});
    return all;
}

std::vector<HallTexel> placeTexels(const Hall &hall, int count) {
    const Model &m = hall.model;
    std::vector<double> areas; // running sums over cells
    for (int i = 0; i < m.cellCount; ++i)
        areas.push_back((i ? areas.back() : 0) + (double)m.cells[i].area * !m.charts[m.cells[i].chart].open);
    std::vector<HallTexel> texels;
    for (int i = 0; i < count; ++i) {
        // Steps of the golden ratio spread the cells evenly
        double at = std::fmod((i + 0.5) * std::numbers::phi, 1) * areas.back();
        auto cell = std::upper_bound(areas.begin(), areas.end(), at) - areas.begin();
        const Texel &t = m.texels[m.cells[cell].corner[i % 4]];
        const Chart &c = m.charts[t.chart];
        HallTexel texel = {t.chart, {}};
        for (int k = 0; k < 4; ++k)
            if (t.visible >> k & 1)
                texel.points.push_back({((float)t.x + (k & 1 ? 0.25f : -0.25f)) * c.width / (float)c.across,
                                        ((float)t.y + (k & 2 ? 0.25f : -0.25f)) * c.height / (float)c.down});
        if (!texel.points.empty()) texels.push_back(texel);
    }
    return texels;
}

TexelLight tracedLight(const Hall &hall, const Scene &scene, const LightOfHall &light,
                       const std::vector<HallTexel> &texels, int side, Workers &workers) {
    std::vector<MeshProbe> probes;
    for (const HallTexel &t : texels) {
        const Chart &c = hall.model.charts[t.chart];
        for (auto [u, v] : t.points)
            probes.push_back({t.chart, c.at(u, v), c.n, {}, {}, {}, {}, 0, 0, c.width + c.height});
    }
    size_t count = probes.size();
    tracePaths(meshOf(hall.model, scene, light.strips), light.around, probes, side, workers);
    if (probes.size() < count) throw std::runtime_error("a texel's sample point is inside a solid");
    TexelLight found;
    const MeshProbe *p = probes.data();
    for (const HallTexel &t : texels) {
        float share = 1.f / (float)t.points.size();
        float reflected = 0, all = 0, drawn = 0;
        for (size_t k = 0; k < t.points.size(); ++k, ++p) {
            reflected += luminance(p->reflected) * share, all += luminance(p->traced) * share;
            if (light.drawn) drawn += luminance(p->lamps) * share;
            found.noise2 += p->noise2 * (double)(share * share);
            found.reflectedNoise2 += p->reflectedNoise2 * (double)(share * share);
        }
        found.reflected.push_back(reflected), found.all.push_back(all), found.drawn.push_back(drawn);
    }
    return found;
}

TexelLight solvedLight(const Hall &hall, const LightOfHall &light, const std::vector<HallTexel> &texels,
                       const std::vector<float> &drawn) {
    // Reflected light is all that arrives, less the direct light of skies, which their planes include
    LightVector reflected = light.relit, all = light.relit;
    for (int k = 0; k < kHallBases.count(); ++k) {
        reflected.direct[k] = k < kFirstSun ? -light.relit.bounced[k] : Rgb{};
        if (light.drawn || k < kFirstSun) all.direct[k] = {};
    }
    TexelPlanes planes(hall.model.texelCount);
    TexelLight found;
    for (bool whole : {false, true}) {
        relight(hall.radiosity, hall.model, whole ? all : reflected, planes.plane);
        std::vector<float> &to = whole ? found.all : found.reflected;
        for (const HallTexel &t : texels) {
            float sum = 0;
            for (const std::array<float, 2> &at : t.points) {
                const Chart &c = hall.model.charts[t.chart];
                sum += luminance({valueAt(planes.plane[0], c, at), valueAt(planes.plane[1], c, at),
                                  valueAt(planes.plane[2], c, at)});
            }
            to.push_back(sum / (float)t.points.size());
            if (whole) to.back() += drawn[to.size() - 1];
        }
    }
    return found;
}

} // namespace odraz::measure
