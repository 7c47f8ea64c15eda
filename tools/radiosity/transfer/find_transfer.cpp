#include "tools/radiosity/transfer/find_transfer.h"

#include "radiosity/light_bases.h"
#include "tools/common/clock.h"
#include "tools/radiosity/rays/lamp_rays.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/transfer/solve_columns.h"
#include "tools/support/machine.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

namespace {

// A lamp of the model or of the settings: one basis of the light.
struct LampSource {
    std::string name;
    std::vector<size_t> materials; // materials that emit its light
    Surroundings outside;          // its balls and suns
};

// Lists all materials that emit and are used, then the balls and suns.
std::vector<LampSource> lampsOf(const Mesh &mesh, const Surroundings &outside) {
    std::vector<LampSource> lamps;
    std::vector<bool> used(mesh.materials.size());
    for (const Triangle &t : mesh.triangles) used[(size_t)t.material] = true;
    for (size_t i = 0; i < mesh.materials.size(); ++i) {
        const MeshMaterial &m = mesh.materials[i];
        if (!used[i] || !(std::max({m.emits[0], m.emits[1], m.emits[2]}) > 0)) continue;
        // Make one lamp of the parts of a picture
        auto sameLamp = std::find_if(lamps.begin(), lamps.end(), [&](const LampSource &lamp) {
            return !m.emissionPicture.path.empty() && lamp.name == m.name;
        });
        if (sameLamp == lamps.end())
            lamps.push_back({m.name, {i}, {}});
        else
            sameLamp->materials.push_back(i);
    }
    for (size_t i = 0; i < outside.lamps.size(); ++i)
        lamps.push_back({"ball " + std::to_string(i + 1), {}, {{}, {}, {outside.lamps[i]}}});
    for (size_t i = 0; i < outside.suns.size(); ++i)
        lamps.push_back({"sun " + std::to_string(i + 1), {}, {{}, {outside.suns[i]}, {}}});
    return lamps;
}

// Combines the lamps from number kMaxLamps on into one, with a note.
void joinLamps(std::vector<LampSource> &lamps, std::vector<std::string> &notes) {
    if (lamps.size() <= (size_t)kMaxLamps) return;
    LampSource &last = lamps[(size_t)kMaxLamps - 1];
    auto append = [](auto &to, const auto &more) { to.insert(to.end(), more.begin(), more.end()); };
    for (size_t i = (size_t)kMaxLamps; i < lamps.size(); ++i) {
        append(last.materials, lamps[i].materials);
        append(last.outside.lamps, lamps[i].outside.lamps);
        append(last.outside.suns, lamps[i].outside.suns);
    }
    notes.push_back("there are " + std::to_string(lamps.size()) + " lamps: all from lamp " +
                    std::to_string(kMaxLamps) + " on are combined into one");
    last.name = "others";
    lamps.resize((size_t)kMaxLamps);
}

// The default numbers of clusters, of axes, and of rays from each site.
int usualClusters(size_t texels, int bands) {
    return std::clamp(bands * bands * 4, 1, (int)std::max(texels / 64, (size_t)1));
}
int usualRank(int bands) { return bands <= 2 ? 8 : bands <= 4 ? 16 : bands == 5 ? 24 : 32; }

int usualRays(size_t sites) {
    return (int)std::clamp(24000000 / std::max(sites, (size_t)1), (size_t)32, (size_t)256);
}

class TransferFinder {
public:
    TransferFinder(const Mesh &mesh, const TransferSettings &s, Workers &workers,
                   const SolveProgress &progress, TransferReport &report)
        : mesh(mesh), s(s), workers(workers), report(report), task(mesh, s.solve, workers, &kNever, progress),
          lamps(lampsOf(mesh, task.settings.surroundings)) {
        joinLamps(lamps, task.report.notes);
    }

    TransferRoom find() {
        show("dividing", 0);
        task.setGeometry(grid.cells, grid.texels);
        findRows();
        ColumnSystem columns(rays, rays.reflectance(task.solution), lights());
        solve(columns);
        spread(columns);
        report.seconds[1] = lap();
        noteClosed();
        compressRows();
        report.seconds[2] = lap();
        findGlossyCharts(columns);
        report.seconds[3] = lap();
        report.notes = std::move(task.report.notes);
        return std::move(room);
    }

private:
    const Surroundings dark;
    const Mesh &mesh;
    const TransferSettings &s;
    Workers &workers;
    TransferReport &report;
    SolveTask task;
    double last = common::processorSeconds();
    const LightGrid grid{mesh, task.regions, workers};
    RaySystem rays{grid, dark, workers};
    std::vector<LampSource> lamps;
    std::vector<std::vector<Rgb>> direct; // direct light of each lamp at the texels
    TransferRoom room;

    void show(const char *step, float done) {
        if (task.progress) task.progress(step, done, -1);
    }
    double lap() {
        double now = common::processorSeconds(), took = now - last;
        last = now;
        return took;
    }
    int lights() const { return s.bands * s.bands + (int)lamps.size(); }

    void findRows() {
        size_t sites = grid.sites.size();
        int count = s.solve.rays > 0 ? s.solve.rays : usualRays(sites);
        report.sites = sites, report.raysFromSite = (size_t)count;
        size_t bytes = ColumnSystem::bytesFor(sites, sites * (size_t)count, lights()) +
                       grid.texels.size() * (size_t)lights() * 3 * sizeof(float) * 3 +
                       sites * (size_t)count * 4;
        if (bytes > s.solve.memory)
            refuseMemory(bytes, s.solve.memory, "larger elements, fewer rays or fewer bands need less");
        rays.setRays(std::vector<uint16_t>(sites, (uint16_t)count));
        for (size_t first = 0, piece = std::max(sites / 50, (size_t)256); first < sites; first += piece) {
            show("rays", (float)first / (float)sites);
            rays.findRows(first, std::min(first + piece, sites));
        }
        report.seconds[0] = lap();
    }

    // Adds light from outside, of radiance 1 times each function of the bands.
    void addBands(ColumnSystem &to) {
        show("bands", 0);
        int functions = s.bands * s.bands;
        rays.alongOpenRays([&](size_t site, const Vec3 &d) {
            Float8 y[kMostSh];
            evaluateBands(broadcast(d), s.bands, y);
            float *light = to.source(site), share = 1 / (float)rays.rays(site);
            for (int k = 0; k < functions; ++k)
                for (int c = 0; c < 3; ++c) light[3 * k + c] += y[k][0] * share;
        });
    }

    // Adds the light of lamp `k` at the sites: along rays if the lamp is large, otherwise by shadow rays.
    void addLamp(size_t k, ColumnSystem &to) {
        show("lamps", (float)k / (float)lamps.size());
        Mesh onlyThis = mesh;
        std::vector<uint8_t> belongs(mesh.materials.size()), emits(task.regions.charts.size());
        for (size_t i : lamps[k].materials) belongs[i] = true;
        for (size_t i = 0; i < belongs.size(); ++i)
            if (!belongs[i]) onlyThis.materials[i].emits = {};
        LampRays lamp(onlyThis, task.regions, s.solve.lampSamples);
        for (size_t c = 0; c < emits.size(); ++c)
            if ((emits[c] = belongs[(size_t)task.regions.material[c]])) room.lampOf[c] = (int)k;
        size_t at = (size_t)(3 * (s.bands * s.bands) + 3 * (int)k);
        if (lamp.share() > kLargeLamps) {
            lamp.clear();
            for (size_t site = 0; site < grid.sites.size(); ++site) {
                float *light = to.source(site) + at, share = 1 / (float)rays.rays(site);
                for (uint64_t i = rays.firstOf[site]; i < rays.firstOf[site + 1]; ++i) {
                    if (rays.rows[i] == RaySystem::kDark) continue;
                    auto chart = (size_t)grid.sites[rays.rows[i]].chart;
                    Rgb e = emits[chart] ? task.solution.emits[chart] * share : Rgb{};
                    light[0] += e.x, light[1] += e.y, light[2] += e.z;
                }
            }
        }
        direct.push_back(directLight(lamp, lamps[k].outside, grid, rays.excluded, workers));
        std::vector<Rgb> means = rays.meansOfPoints(direct.back());
        for (size_t site = 0; site < means.size(); ++site) {
            float *light = to.direct(site) + at;
            light[0] = means[site].x, light[1] = means[site].y, light[2] = means[site].z;
        }
    }

    void solve(ColumnSystem &columns) {
        room.lampOf.assign(task.regions.charts.size(), -1);
        addBands(columns);
        for (size_t k = 0; k < lamps.size(); ++k) addLamp(k, columns);
        show("solving", 0);
        columns.solve(s.solve.residual, workers);
    }

    void noteClosed() {
        const float *even = room.plane(0, 0);
        if (std::all_of(even, even + room.texels(), [](float x) { return x == 0; }))
            task.report.notes.emplace_back("no light from outside enters: only the lamps light this room");
    }

    // Spreads light from the sites to the texels, in planes.
    void spread(const ColumnSystem &columns) {
        show("spreading", 0);
        auto width = (size_t)columns.columns();
        std::vector<float> texels(grid.texels.size() * width);
        rays.atTexels(kShared, columns.arrives(), (int)width, texels.data());
        room.bands = s.bands, room.upIsZ = s.upIsZ;
        for (const LampSource &lamp : lamps) room.lamps.push_back(lamp.name);
        room.model = std::move(task.solution);
        room.model.light.assign(grid.texels.size(), {});
        room.planes.resize((size_t)lights() * 3 * room.stride());
        parallelFor(workers, lights(), [&](int k, int) {
            std::vector<Rgb> light(grid.texels.size());
            int lamp = k - room.functions();
            for (size_t t = 0; t < light.size(); ++t) {
                const float *from = &texels[t * width + (size_t)(3 * k)];
                light[t] = {from[0], from[1], from[2]};
                if (lamp >= 0) light[t] += direct[(size_t)lamp][t];
            }
            grid.fill(light);
            for (size_t t = 0; t < light.size(); ++t)
                room.plane(k, 0)[t] = light[t].x, room.plane(k, 1)[t] = light[t].y,
                              room.plane(k, 2)[t] = light[t].z;
        });
    }

    void compressRows() {
        show("clusters", 0);
        int most = (int)std::min(room.texels(), (size_t)kMostClusters),
            clusters = std::min(s.clusters > 0 ? s.clusters : usualClusters(room.texels(), s.bands), most);
        room.clusters = clustersOf(room, clusters, s.rank > 0 ? s.rank : usualRank(s.bands), workers);
    }

    void findGlossyCharts(const ColumnSystem &columns) {
        if (s.glossy.empty()) return;
        std::vector<size_t> charts;
        double area = 0;
        for (size_t c = 0; c < room.model.charts.size(); ++c)
            if (mesh.materials[(size_t)task.regions.material[c]].name == s.glossy) {
                charts.push_back(c);
                area += (double)(room.model.charts[c].width * room.model.charts[c].height);
            }
        if (charts.empty()) throw common::Refused("--glossy: no polygon has the material " + s.glossy);
        if (charts.size() > (size_t)kMostGlossyCharts)
            throw common::Refused("--glossy: " + s.glossy + " has " + std::to_string(charts.size()) +
                                  " planes, more than " + std::to_string(kMostGlossyCharts) +
                                  ": choose a material with fewer planes, such as a floor's");
        auto side = (float)std::sqrt(area / (kMostSquares / 4.));
        room.polish = s.polish;
        int functions = room.functions();
        // Radiance reflected and emitted where a ray hits, or the bands' radiance if it hits nothing
        Arrives arrives = [&](const Vec3 &from, const Vec3 &d, float *to) {
            RayHit hit = grid.tree.nearest(from, d);
            if (hit.triangle < 0) {
                Float8 y[kMostSh];
                evaluateBands(broadcast(d), s.bands, y);
                for (int k = 0; k < functions; ++k)
                    for (int c = 0; c < 3; ++c) to[3 * k + c] = y[k][0];
                return;
            }
            if (hit.back) return;
            int chart = task.regions.chartOf[(size_t)hit.triangle];
            auto spot = grid.spotAt(chart, from + d * hit.t);
            float weights[4], all = grid.weigh(spot, weights);
            for (int k = 0; k < 4; ++k) {
                if (!(weights[k] > 0)) continue;
                const float *b = columns.reflected(grid.siteOf[(size_t)spot.cell->corner[k]]);
                for (int i = 0; i < 3 * lights(); ++i) to[i] += b[i] * (weights[k] / all);
            }
            if (int lamp = room.lampOf[(size_t)chart]; lamp >= 0) {
                Rgb e = room.model.emits[(size_t)chart];
                float *at = to + 3 * (functions + lamp);
                at[0] += e.x, at[1] += e.y, at[2] += e.z;
            }
        };
        for (size_t i = 0; i < charts.size(); ++i) {
            show("gloss", (float)i / (float)charts.size());
            room.gloss.push_back(findGloss(room.model.charts[charts[i]], (int)charts[i], lights(), side,
                                           s.glossRays, s.exponent, arrives, workers));
            report.squares += room.gloss.back().across * room.gloss.back().down;
        }
    }
};

} // namespace

std::vector<float> columnScale(const TransferRoom &room, const std::vector<float> &rows) {
    auto width = (size_t)room.columns(), skies = (size_t)(3 * room.functions());
    std::vector<double> squares(1 + room.lamps.size());
    auto kindOf = [&](size_t column) {
        return column < skies ? 0 : std::min(1 + (column - skies) / 3, squares.size() - 1);
    };
    for (size_t i = 0; i < rows.size(); ++i) squares[kindOf(i % width)] += (double)(rows[i] * rows[i]);
    std::vector<float> scale(width);
    for (size_t k = 0; k < width; ++k) {
        double size = std::sqrt(squares[kindOf(k)]);
        scale[k] = size > 0 ? (float)(1 / size) : 1;
    }
    return scale;
}

Clusters clustersOf(const TransferRoom &room, int count, int rank, Workers &workers) {
    std::vector<float> rows = room.rows(), scale = columnScale(room, rows);
    return findClusters(std::move(rows), room.columns(), scale, blocksOf(room.model, count), {count, rank},
                        workers);
}

TransferRoom findTransfer(const Mesh &mesh, const TransferSettings &settings, Workers &workers,
                          const SolveProgress &progress, TransferReport &report) {
    return TransferFinder(mesh, settings, workers, progress, report).find();
}

} // namespace odraz::radiosity
