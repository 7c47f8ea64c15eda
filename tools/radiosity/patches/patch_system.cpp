#include "tools/radiosity/patches/patch_system.h"
#include "base/random.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

std::vector<Rgb> PatchSystem::reflectDirect() const {
    std::vector<Rgb> all;
    for (size_t i = 0; i < patches.size(); ++i) all.push_back(patches[i].reflects * direct[i]);
    return all;
}

float PatchSystem::sweep(std::vector<Rgb> &b, bool atOnce) const {
    Rgb initial = {}, change = {};
    std::vector<Rgb> before;
    if (!atOnce) before = b;
    for (size_t i = 0; i < patches.size(); ++i) {
        const Rgb &reflects = patches[i].reflects;
        Rgb now = reflects * (direct[i] + rows.gather((int)i, atOnce ? b : before));
        initial += reflects * direct[i];
        change += {std::fabs(now.x - b[i].x), std::fabs(now.y - b[i].y), std::fabs(now.z - b[i].z)};
        b[i] = now;
    }
    auto share = [](float part, float all) { return all > 0 ? part / all : 0; };
    return std::max({share(change.x, initial.x), share(change.y, initial.y), share(change.z, initial.z)});
}

// Rays follow the cosine law, in a spiral (Vogel, 1979: the golden angle on a disc) with a different rotation
// at every texel. They start from the texel's sample points in turn.
std::vector<Rgb> skyLight(const SkyPicture &sky, const LightGrid &grid, const RayTree &tree,
                          Workers &workers) {
    constexpr int kRays = 256;
    std::vector<std::vector<Vec3>> pointsOf(grid.texels.size());
    for (const LightGrid::SamplePoint &point : grid.points) pointsOf[(size_t)point.texel].push_back(point.p);
    std::vector<Rgb> light(grid.texels.size());
    parallelRanges(workers, (int)light.size(), 64, [&](int first, int end, int) {
        for (auto t = (size_t)first; t < (size_t)end; ++t) {
            const Chart &c = grid.charts[(size_t)grid.texels[t].chart];
            const std::vector<Vec3> &points = pointsOf[t];
            float begin = unitFloat(pcg((uint32_t)t)) * 6.2831853f;
            for (int k = 0; k < kRays && !points.empty(); ++k) {
                float square = ((float)k + 0.5f) / kRays, out = std::sqrt(square),
                      turn = begin + 2.3999632f * (float)k;
                Vec3 d =
                    c.u * (out * std::cos(turn)) + c.v * (out * std::sin(turn)) + c.n * std::sqrt(1 - square);
                if (!tree.blocked(points[(size_t)k % points.size()], d, kInfinity))
                    light[t] += sky.radiance(d) * (1.f / kRays);
            }
        }
    });
    return light;
}

} // namespace odraz::radiosity
