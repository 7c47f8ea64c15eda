// A mesh, solved by rays from every element.
#include "tools/radiosity/bake.h"
#include "tools/radiosity/gather.h"
#include "tools/radiosity/lamp_rays.h"

#include <algorithm>
#include <cmath>

namespace odraz {

namespace {

// What of a site's light its rays and its neighbours' may leave open, and what may be wrong of it where light
// passes from site to site
constexpr float kError = 0.01f, kShared = 0.2f, kFinalShared = 0.1f;

class RayBaker {
public:
    RayBaker(Bake &b, const Mesh &mesh, Workers &workers, const int *stop, const Told &told)
        : b(b), s(b.settings), mesh(mesh), workers(workers), stop(stop), told(told),
          last(processorSeconds()) {}

    void run() {
        b.whole = true;
        tell(0, 0);
        RayTree tree(cornersOf(mesh));
        tell(0, 0.4f);
        LightGrid grid(b.regions, tree, workers);
        b.sites = (int)grid.sites.size();
        lap(0);
        Gather gather(b.regions, grid, tree, s.surroundings);
        auto first = (uint16_t)(s.rays > 0 ? s.rays : Gather::kLeastRays);
        findRows(gather, std::vector<uint16_t>(grid.sites.size(), first));
        lap(1);
        tell(2, 0);
        LampRays lamps(mesh, b.regions, s.lampSamples);
        std::vector<Rgb> direct = directLight(lamps, s.surroundings, grid, gather.behind, tree, workers);
        prepare(gather, grid, direct);
        lap(2);
        if (s.rays == 0 && b.whole) {
            // A first solution tells where more rays are needed
            gather.solve(atSites, reflects, false, 0.01f, 100, workers, [](float) { return true; });
            lap(3);
            findRows(gather, gather.raysFor(atSites, reflects, kError, kShared, workers));
            lap(1);
        }
        b.rays = gather.rows.size() / std::max(grid.sites.size(), (size_t)1);
        solve(gather);
        b.arrives = settled(gather, grid, direct, kShared);
        if (s.final > 0 && b.whole) {
            tell(4, 0);
            auto reflectsAt = [&](const Cell &c) { return b.reflects(c.chart); };
            gather.gatherFinal(s.final, b.arrives, reflectsAt, workers);
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
    double last;      // when the last step ended
    double begin = 0; // the logarithm of the first residual
    std::vector<Rgb> atSites, reflects;

    void tell(int step, float done, float residual = -1) {
        if (told) told(Bake::kSteps[step], done, residual);
    }
    bool stopped() const { return __atomic_load_n(stop, __ATOMIC_RELAXED) != 0; }
    void lap(int step) {
        double now = processorSeconds(), took = now - last;
        b.seconds[step] += took, b.seconds[4] += took;
        last = now;
    }

    // Finds rows of so many rays, where they are not there.
    void findRows(Gather &gather, const std::vector<uint16_t> &rays) {
        size_t missing = gather.setRays(rays), count = rays.size(), done = 0;
        size_t piece = std::clamp(count / 100, (size_t)256, (size_t)8192);
        for (size_t first = 0; first < count; first += piece) {
            size_t end = std::min(first + piece, count);
            tell(1, (float)done / (float)std::max(missing, (size_t)1));
            if (stopped()) {
                b.whole = false;
                return;
            }
            for (size_t i = first; i < end; ++i) done += !gather.found[i];
            gather.findRows(first, end, workers);
            b.rows = (int)end;
        }
    }

    // What the sites get directly, and reflect.
    void prepare(const Gather &gather, const LightGrid &grid, const std::vector<Rgb> &direct) {
        atSites.resize(grid.sites.size()), reflects.resize(grid.sites.size());
        for (size_t i = 0; i < grid.sites.size(); ++i) {
            const LightGrid::Site &site = grid.sites[i];
            int count = 0;
            for (uint32_t k = 0; k < site.places; ++k)
                if (!(gather.behind[i] >> k & 1))
                    atSites[i] += direct[(size_t)grid.places[site.firstPlace + k].texel], ++count;
            atSites[i] = atSites[i] * (1 / (float)count);
            reflects[i] = b.reflects(site.chart);
        }
    }

    void solve(Gather &gather) {
        bool counted = s.bounces >= 0;
        auto swept = [&](float left) {
            b.left = left;
            double now = std::log(std::max((double)left, 1e-12)), end = std::log((double)s.residual);
            if (begin == 0) begin = now;
            tell(3, (float)std::clamp(begin <= end ? 1 : (begin - now) / (begin - end), 0., 1.), left);
            return !stopped();
        };
        b.sweeps =
            gather.solve(atSites, reflects, counted, s.residual, counted ? s.bounces : 10000, workers, swept);
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
