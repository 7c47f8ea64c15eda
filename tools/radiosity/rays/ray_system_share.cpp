// RaySystem: values of sites, sharing of light between sites, and the number of rays that this needs.
#include "tools/radiosity/rays/ray_system.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

std::vector<Rgb> RaySystem::meansOfPoints(const std::vector<Rgb> &texels) const {
    std::vector<Rgb> means(grid.sites.size());
    for (size_t i = 0; i < means.size(); ++i) {
        const LightGrid::Site &site = grid.sites[i];
        int count = 0;
        for (uint32_t k = 0; k < site.pointCount; ++k)
            if (!(excluded[i] >> k & 1))
                means[i] += texels[(size_t)grid.points[site.firstPoint + k].texel], ++count;
        means[i] = means[i] * (1 / (float)count);
    }
    return means;
}

std::vector<Rgb> RaySystem::reflectance(const Solution &solution) const {
    std::vector<Rgb> reflects(grid.sites.size());
    const std::vector<Rgb> &ofCell = solution.cellReflects;
    for (size_t i = 0; i < reflects.size(); ++i) {
        const LightGrid::Site &site = grid.sites[i];
        if (ofCell.empty()) {
            reflects[i] = solution.reflects[(size_t)site.chart];
            continue;
        }
        for (uint32_t k = 0; k < site.pointCount; ++k) {
            auto *cell = grid.spotAt(site.chart, grid.points[site.firstPoint + k].p).cell;
            reflects[i] += ofCell[(size_t)(cell - grid.cells.data())] * (1 / (float)site.pointCount);
        }
    }
    return reflects;
}

template <class Visit>
void RaySystem::forNeighbours(uint32_t site, const Vec3 &p, float share, const Visit &visit) const {
    const LightGrid::Site &s = grid.sites[site];
    float radius = std::min(share * reach[site], 3.5f * s.size);
    if (radius < 0.7f * s.size) return;
    Vec3 n = grid.charts[(size_t)s.chart].n;
    near.within(p, radius, [&](uint32_t i, float distance) {
        const LightGrid::Site &other = grid.sites[i];
        const Vec3 &m = grid.charts[(size_t)other.chart].n;
        float bend = std::sqrt(2 * std::max(0.f, 1 - dot(n, m)));
        float change =
            (distance / std::sqrt(std::min(reach[site], 1e15f) * std::min(reach[i], 1e15f)) + bend) / share;
        // A site off the mean plane sees surfaces that this one does not
        if (change >= 1 || std::fabs(dot(near.at(i) - p, n + m)) > 0.2f * radius) return;
        visit(i, (1 - change) * (1 - distance / radius) * other.size * other.size);
    });
}

std::vector<uint16_t> RaySystem::raysFor(const std::vector<Rgb> &direct, const std::vector<Rgb> &reflects,
                                         float error, float share) const {
    size_t count = grid.sites.size();
    std::vector<float> variance(count), wanted(count);
    parallelRanges(workers, (int)count, 256, [&](int first, int end, int) {
        for (auto i = (size_t)first; i < (size_t)end; ++i) {
            double sum = (double)luminance(sky[i]), squares = (double)skySquare[i],
                   share = 1 / (double)rays(i);
            for (uint64_t k = firstOf[i]; k < firstOf[i + 1]; ++k)
                if (uint32_t j = rows[k]; j != kDark) {
                    auto l = (double)luminance(reflects[j] * (direct[j] + arrives[j]) + emitted(j));
                    sum += l * share, squares += l * l * share;
                }
            variance[i] = (float)std::max(squares - sum * sum, 0.);
        }
    });
    parallelRanges(workers, (int)count, 256, [&](int first, int end, int) {
        for (auto i = (size_t)first; i < (size_t)end; ++i) {
            // A few rays may miss something small and bright, so the hits of nearby sites count too
            float all = variance[i], light = luminance(direct[i] + arrives[i]), weights = 1, sum = 0,
                  square = 0;
            forNeighbours((uint32_t)i, near.at((uint32_t)i), share, [&](uint32_t k, float w) {
                w /= grid.sites[i].size * grid.sites[i].size;
                all += w * variance[k], light += w * luminance(direct[k] + arrives[k]), weights += w;
                sum += w, square += w * w;
            });
            float sharers = square > 0 ? sum * sum / square : 1, least = error * light / weights;
            // With more rays the error of a spiral falls faster than the error of random rays
            if (least > 0) wanted[i] = std::pow(all / weights / (sharers * least * least), 1 / 1.4f);
        }
    });
    double scale = 1;
    std::vector<uint16_t> all(count);
    for (int tries = 0; tries < 20; ++tries, scale *= 0.7) {
        double sum = 0;
        for (size_t i = 0; i < count; ++i) {
            uint16_t n = kLeastRays;
            while (n < kMostRays && (double)n < (double)wanted[i] * scale) n = (uint16_t)(n * 2);
            sum += all[i] = n;
        }
        if (sum <= kAllRays) break;
    }
    return all;
}

std::vector<Rgb> RaySystem::atTexels(float share) const {
    std::vector<Rgb> light(grid.texels.size());
    parallelRanges(workers, (int)grid.texels.size(), 256, [&](int first, int end, int) {
        for (int t = first; t < end; ++t) {
            uint32_t site = grid.siteOf[(size_t)t];
            if (site == LightGrid::kNone) continue;
            Rgb sum = {};
            float weights = 0;
            forNeighbours(site, grid.at(grid.texels[(size_t)t]), share,
                          [&](uint32_t i, float w) { sum += arrives[i] * w, weights += w; });
            light[(size_t)t] = weights > 0 ? sum * (1 / weights) : arrives[site];
        }
    });
    return light;
}

void RaySystem::atTexels(float share, const float *values, int columns, float *texels) const {
    auto width = (size_t)columns;
    parallelRanges(workers, (int)grid.texels.size(), 256, [&](int first, int end, int) {
        std::vector<std::pair<uint32_t, float>> all;
        for (int t = first; t < end; ++t) {
            uint32_t site = grid.siteOf[(size_t)t];
            if (site == LightGrid::kNone) continue;
            all.clear();
            float weights = 0;
            forNeighbours(site, grid.at(grid.texels[(size_t)t]), share, [&](uint32_t i, float w) {
                all.push_back({i, w}), weights += w;
            });
            if (!(weights > 0)) all.assign(1, {site, weights = 1});
            float *to = texels + (size_t)t * width;
            for (auto [other, weight] : all)
                for (size_t k = 0; k < width; k += 8)
                    store(to + k,
                          fmadd(load(values + other * width + k), broadcast(weight / weights), load(to + k)));
        }
    });
}

} // namespace odraz::radiosity
