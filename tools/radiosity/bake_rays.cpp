// A mesh, solved by rays from every element.
#include "tools/common/clock.h"
#include "tools/radiosity/arrays.h"
#include "tools/radiosity/bake.h"
#include "tools/radiosity/gather.h"
#include "tools/radiosity/lamp_rays.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odraz {

namespace {

// What of a site's light its rays and its neighbours' may leave open, and what may be wrong of it where light
// passes from site to site
constexpr double kLarge = 0.25; // of the model's area: what shines is no lamp
constexpr float kFirst = 0.25f; // what share of all rays' time the first ones take, about
constexpr float kError = 0.014f, kShared = 0.2f, kFinalShared = 0.1f;

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
        estimate();
        LightGrid grid(b.regions, tree, workers);
        b.sites = (int)grid.sites.size();
        b.pictured.find(mesh, b.regions.chartOf, b.regions.charts, grid.cells, b.notes);
        tell(0, 1);
        lap(0);
        Gather gather(b.regions, grid, tree, s.surroundings);
        bool refined = resume(gather);
        auto first = (uint16_t)(s.rays > 0 ? s.rays : Gather::kLeastRays);
        if (!refined)
            findRows(gather, std::vector<uint16_t>(grid.sites.size(), first), false, 0,
                     s.rays > 0 ? 1 : kFirst);
        gather.judges = false;
        lap(1);
        tell(2, 0);
        LampRays lamps(mesh, b.regions, s.lampSamples);
        if (lamps.share() > kLarge) { // rays find them better than samples
            for (int i = 0; i < (int)b.material.size(); ++i) gather.emits.push_back(b.emits(i));
            lamps.clear();
        }
        std::vector<Rgb> direct = directLight(lamps, s.surroundings, grid, gather.behind, tree, workers);
        prepare(gather, grid, direct);
        lap(2);
        tell(2, 1);
        b.cells = grid.cells, b.texels = grid.texels;
        if (s.growing) {
            std::vector<Rgb> light = direct;
            grid.fill(light);
            show(std::move(light));
        }
        if (s.rays == 0 && b.whole) {
            std::vector<uint16_t> rays(grid.sites.size());
            for (size_t i = 0; i < rays.size(); ++i) rays[i] = (uint16_t)gather.rays(i);
            if (!refined) {
                // A first solution tells where more rays are needed
                gather.solve(atSites, reflects, false, 0.01f, 100, workers, [](float) { return true; });
                lap(3);
                rays = gather.raysFor(atSites, reflects, kError, kShared, workers);
            }
            findRows(gather, rays, true, kFirst, 1);
            lap(1);
        }
        b.rays = gather.rows.size() / std::max(grid.sites.size(), (size_t)1);
        solve(gather, grid, direct);
        b.arrives = settled(gather, grid, direct, kShared);
        if (s.final > 0 && b.whole) {
            tell(4, 0);
            auto reflectsAt = [&](int cell) { return b.reflectsOf(cell); };
            gather.gatherFinal(s.final, b.arrives, reflectsAt, workers);
            b.arrives = settled(gather, grid, direct, kFinalShared);
            tell(4, 1);
        }
        lap(3);
        if (told) told(nullptr, 1, b.left);
    }

private:
    Bake &b;
    BakeSettings &s;
    const Mesh &mesh;
    Workers &workers;
    const int *stop;
    const Told &told;
    double last; // when the last step ended
    double kept = wallSeconds();
    SolvedShare share;
    std::vector<Rgb> atSites, reflects;

    // Tells what memory it takes, and refuses what is more than there shall be.
    void estimate() const {
        size_t charts = b.regions.charts.size(), texels = 0, cells = 0, sites = 0;
        for (const Chart &c : b.regions.charts) {
            bool small = c.across == 1 && c.down == 1;
            texels += (size_t)c.texels(), cells += (size_t)c.across * (size_t)c.down;
            sites += small ? 1 : (size_t)c.texels();
        }
        double first = s.rays > 0 ? s.rays : Gather::kLeastRays, sent = (double)sites * first;
        if (s.rays == 0)
            sent += std::max(sent, std::min((double)sites * Gather::kMostRays, Gather::kAllRays));
        size_t bytes = mesh.points.size() * sizeof(Vec3d) + mesh.triangles.size() * (sizeof(Triangle) + 40) +
                       RayTree::bytesFor(mesh.triangles.size()) +
                       charts * (sizeof(Chart) + 2 * sizeof(Facet)) + cells * 2 * sizeof(Cell) +
                       texels * (2 * sizeof(Texel) + 5 * sizeof(Rgb) + 24) + sites * 260 + (size_t)sent * 4;
        if (bytes > s.memory) refuseMemory(bytes, s.memory, "larger elements or fewer rays need less");
        if (s.needs) s.needs(bytes);
    }

    void tell(int step, float done, float residual = -1) {
        if (told) told(Bake::kSteps[step], done, residual);
    }
    bool stopped() const { return __atomic_load_n(stop, __ATOMIC_RELAXED) != 0; }
    void lap(int step) {
        double now = processorSeconds(), took = now - last;
        b.seconds[step] += took, b.seconds[4] += took;
        last = now;
    }

    // Takes up what was kept. Returns whether it knew how many rays are needed where.
    bool resume(Gather &gather) {
        if (s.resumed.empty()) return false;
        size_t at = 0;
        std::vector<uint8_t> refined;
        if (!get(s.resumed, at, refined) || refined.size() != 1 || !gather.restore(s.resumed, at) ||
            at != s.resumed.size())
            refuseKept();
        s.resumed.clear();
        return refined[0];
    }

    void keep(const Gather &gather, bool refined) {
        if (!s.keep) return;
        std::string rows;
        put(rows, std::vector<uint8_t>{refined});
        gather.save(rows);
        s.keep(rows);
        kept = wallSeconds();
    }

    // Finds rows of so many rays, where they are not there; of the whole step that is from .. to.
    void findRows(Gather &gather, const std::vector<uint16_t> &rays, bool refined, float from, float to) {
        size_t missing = gather.setRays(rays), count = rays.size(), done = 0;
        size_t piece = std::clamp(count / 100, (size_t)256, (size_t)8192);
        for (size_t first = 0; first < count; first += piece) {
            size_t end = std::min(first + piece, count);
            tell(1, from + (to - from) * (float)done / (float)std::max(missing, (size_t)1));
            if (stopped()) b.whole = false;
            if (stopped() || wallSeconds() - kept > s.keepEvery) keep(gather, refined);
            if (!b.whole) return;
            for (size_t i = first; i < end; ++i) done += !gather.found[i];
            gather.findRows(first, end, workers);
            b.rows = (int)end;
        }
        tell(1, to);
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
            if (b.pictured.ofCell.empty()) continue;
            reflects[i] = {};
            for (uint32_t k = 0; k < site.places; ++k) {
                auto *cell = grid.spotAt(site.chart, grid.places[site.firstPlace + k].p).cell;
                reflects[i] +=
                    b.pictured.ofCell[(size_t)(cell - grid.cells.data())] * (1 / (float)site.places);
            }
        }
    }

    // For those who watch.
    void show(std::vector<Rgb> light) {
        b.arrives = std::move(light);
        s.growing(b, nullptr);
    }

    void solve(Gather &gather, const LightGrid &grid, const std::vector<Rgb> &direct) {
        bool counted = s.bounces >= 0;
        auto swept = [&](float left) {
            b.left = left;
            if (b.whole && wallSeconds() - kept > s.keepEvery) keep(gather, s.rays == 0);
            tell(3, share(left, s.residual), left);
            if (s.growing && (!s.looks || s.looks())) show(settled(gather, grid, direct, kShared));
            return !stopped();
        };
        b.sweeps =
            gather.solve(atSites, reflects, counted, s.residual, counted ? s.bounces : 10000, workers, swept);
        bool done = counted ? b.sweeps == s.bounces : b.left <= s.residual;
        if (b.whole && !done && stopped()) {
            b.whole = false;
            keep(gather, s.rays == 0);
        }
        if (!counted && !done && !stopped())
            b.notes.push_back("it does not converge: what reflects all light, Kd 1, never comes to an end");
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
