// Divides the emitting triangles of a mesh into parts.
#include "base/maths.h"
#include "tools/radiosity/rays/lamp_rays.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

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

} // namespace odraz::radiosity
