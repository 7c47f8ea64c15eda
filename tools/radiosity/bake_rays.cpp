// A mesh of many small polygons, solved by rays from every element.
#include "tools/radiosity/bake.h"
#include "tools/radiosity/gather.h"
#include "tools/radiosity/lamp_rays.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odraz {

namespace {

constexpr double kAllRays = 24e6, kLeastRays = 48, kMostRays = 512;
// How much of its light may be wrong where it passes from site to site
constexpr float kShared = 0.2f, kFinalShared = 0.1f;

class RayBaker {
public:
    RayBaker(Bake &b, const Mesh &mesh, Workers &workers, const int *stop, const Told &told)
        : b(b), s(b.settings), mesh(mesh), workers(workers), stop(stop), told(told) {}

    void run() {
        double began = processorSeconds(), last = began;
        auto lap = [&](int step) {
            double now = processorSeconds();
            b.seconds[step] = now - last;
            last = now;
            b.seconds[4] = now - began;
        };
        tell(0, 0);
        RayTree tree(cornersOf(mesh));
        tell(0, 0.4f);
        LightGrid grid(b.regions, tree, workers);
        b.sites = (int)grid.sites.size();
        lap(0);
        b.rays =
            s.rays > 0 ? s.rays : (int)std::clamp(kAllRays / std::max(b.sites, 1), kLeastRays, kMostRays);
        Gather gather(b.regions, grid, tree, s.surroundings, b.rays);
        findRows(gather);
        lap(1);
        tell(2, 0);
        LampRays lamps(mesh, b.regions, s.lampSamples);
        std::vector<Rgb> direct = directLight(lamps, s.surroundings, grid, gather.behind, tree, workers);
        lap(2);
        solve(gather, grid, direct);
        b.arrives = settled(gather, grid, direct, kShared);
        if (s.final > 0 && b.whole) {
            tell(4, 0);
            gather.gatherFinal(
                s.final, b.arrives, [&](const Cell &c) { return b.reflects(c.chart); }, workers);
            b.arrives = settled(gather, grid, direct, kFinalShared);
        }
        lap(3);
        b.cells = std::move(grid.cells), b.texels = std::move(grid.texels);
        if (told) told(nullptr, 1, b.left);
    }

private:
    Bake &b;
    BakeSettings &s;
    const Mesh &mesh;
    Workers &workers;
    const int *stop;
    const Told &told;
    double begin = 0; // the logarithm of the first residual

    void tell(int step, float done, float residual = -1) {
        if (told) told(Bake::kSteps[step], done, residual);
    }
    bool stopped() const { return __atomic_load_n(stop, __ATOMIC_RELAXED) != 0; }

    void findRows(Gather &gather) {
        b.whole = true;
        auto count = (size_t)b.sites, piece = std::clamp(count / 100, (size_t)256, (size_t)8192);
        for (size_t first = 0; first < count; first += piece) {
            tell(1, (float)first / (float)count);
            if (stopped()) {
                b.whole = false;
                std::fill(gather.rows.begin() + (ptrdiff_t)(first * (size_t)b.rays), gather.rows.end(),
                          Gather::kDark);
                break;
            }
            gather.findRows(first, std::min(first + piece, count), workers);
            b.rows = (int)std::min(first + piece, count);
        }
    }

    void solve(Gather &gather, const LightGrid &grid, const std::vector<Rgb> &direct) {
        std::vector<Rgb> atSites(grid.sites.size()), reflects(grid.sites.size());
        for (size_t i = 0; i < grid.sites.size(); ++i) {
            const LightGrid::Site &site = grid.sites[i];
            int count = 0;
            for (uint32_t k = 0; k < site.places; ++k)
                if (!(gather.behind[i] >> k & 1))
                    atSites[i] += direct[(size_t)grid.places[site.firstPlace + k].texel], ++count;
            atSites[i] = atSites[i] * (1 / (float)count);
            reflects[i] = b.reflects(site.chart);
        }
        bool counted = s.bounces >= 0;
        b.sweeps = gather.solve(
            atSites, reflects, counted, s.residual, counted ? s.bounces : 10000, workers, [&](float left) {
                b.left = left;
                double now = std::log(std::max((double)left, 1e-12)), end = std::log((double)s.residual);
                if (begin == 0) begin = now;
                tell(3, (float)std::clamp(begin <= end ? 1 : (begin - now) / (begin - end), 0., 1.), left);
                return !stopped();
            });
    }

    // Light on all texels.
    std::vector<Rgb> settled(const Gather &gather, const LightGrid &grid, const std::vector<Rgb> &direct,
                             float share) {
        std::vector<Rgb> light = gather.atTexels(share, workers);
        for (size_t t = 0; t < light.size(); ++t) light[t] += direct[t];
        grid.fill(light);
        return light;
    }
};

} // namespace

void bakeByRays(Bake &b, const Mesh &mesh, Workers &workers, const int *stop, const Told &told) {
    RayBaker(b, mesh, workers, stop, told).run();
}

} // namespace odraz
