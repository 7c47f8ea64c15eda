#include "tools/radiosity/transfer/check.h"

#include "base/random.h"
#include "tools/radiosity/read/upright.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/radiosity/transfer/environment.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace odraz::radiosity {

namespace {

// Adds a lobe around a direction, as wide as the cosine to the power of `exponent`.
void addLobe(BandLight &to, int bands, const Vec3 &towards, float exponent, const Rgb &colour) {
    Float8 y[kMostSh];
    evaluateBands(broadcast(normalize(towards)), bands, y);
    for (int k = 0; k < bands * bands; ++k) to[(size_t)k] += colour * (y[k][0] * window(bandOf(k), exponent));
}

} // namespace

std::vector<TriedSky> bandLimitedSkies(int bands, bool upIsZ) {
    auto direction = [&](float x, float y, float z) { return asInModel({x, y, z}, upIsZ); };
    std::vector<TriedSky> all(5);
    const char *names[] = {"even", "gradient", "glow", "two lights", "random"};
    auto even = (float)std::sqrt(4 * std::numbers::pi);
    for (size_t i = 0; i < all.size(); ++i) {
        all[i].name = names[i];
        all[i].light[0] = Rgb{0.7f, 0.8f, 1} * even;
    }
    addLobe(all[1].light, std::min(bands, 2), direction(0, 1, 0), 1e6f, {1.5f, 1.7f, 2});
    addLobe(all[2].light, bands, direction(0.8f, 0.35f, -0.5f), 12, {20, 12, 5});
    addLobe(all[3].light, bands, direction(-0.6f, 0.7f, 0.4f), 12, {3, 6, 12});
    addLobe(all[3].light, bands, direction(0.5f, 0.2f, 0.9f), 12, {14, 4, 2});
    for (int k = 1; k < bands * bands; ++k) {
        auto random = [k](int c) { return 2 * (unitFloat(pcg((uint32_t)(3 * k + c))) - 0.5f); };
        all[4].light[(size_t)k] = {random(0), random(1), random(2)};
    }
    for (TriedSky &s : all) s.sky = pictureOf(s.light, bands, upIsZ);
    return all;
}

namespace {

// The root mean square of a - b, as a share of the root mean square of b.
double difference(const std::vector<Rgb> &a, const std::vector<Rgb> &b) {
    double lost = 0, all = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        Rgb d = a[i] - b[i];
        lost += (double)dot(d, d), all += (double)dot(b[i], b[i]);
    }
    return all > 0 ? std::sqrt(lost / all) : lost > 0 ? INFINITY : 0;
}

struct Stopped {}; // thrown when the user interrupts

// Compares a room with solutions.
class RoomCheck {
public:
    RoomCheck(const Mesh &mesh, const TransferSettings &settings, const TransferRoom &room, int rays,
              Workers &workers, const int *stop)
        : mesh(mesh), settings(settings), room(room), rays(rays), workers(workers), stop(stop) {
        lighting.lamps.resize(room.lamps.size()), lighting.bands = room.bands;
        for (MeshMaterial &m : dark.materials) m.emits = {};
    }

    void printSkies() {
        for (const TriedSky &sky : skies) {
            exact.push_back(solveSky(sky, rays));
            relight(sky.light);
            // For every other sky (all would be slow), also solve with as many rays as the light needs
            std::vector<Rgb> others;
            if (exact.size() % 2) others = solveSky(sky, 0);
            printErrors(sky.name, exact.back(), others);
        }
    }
    void printLamps() {
        if (room.lamps.empty()) return;
        std::fill(lighting.lamps.begin(), lighting.lamps.end(), 1.f);
        relight({});
        const Surroundings &given = settings.solve.surroundings;
        std::vector<Rgb> lit = solve(mesh, rays, {{}, given.suns, given.lamps});
        printErrors("all lamps", lit, {});
        std::fill(lighting.lamps.begin(), lighting.lamps.end(), 0.f);
    }
    void printPictures(const std::vector<std::string> &paths) {
        for (const std::string &path : paths) {
            std::vector<std::string> notes;
            Projected projected = readEnvironment(path, room.upIsZ, &notes);
            TriedSky sky = {path.substr(path.rfind('/') + 1), projected.light, {}, {}};
            sky.sky = readSky(path, room.upIsZ, sky.suns);
            relight(sky.light);
            std::vector<Rgb> lit = solveSky(sky, rays);
            printErrors(sky.name, lit, {});
            notes.push_back(bandLossText(sky.name, projected, room.bands));
            for (const std::string &note : notes) std::printf("        (%s)\n", note.c_str());
        }
    }
    // Compares one subspace for all rows with one for each cluster, at the same number of stored floats. Call
    // it after printSkies().
    void printSubspaces() {
        std::vector<float> rows = room.rows(), scale = columnScale(room, rows);
        Workers stopping = workers;
        stopping.abort = stop;
        const int most = room.clusters.rank;
        for (int rank = std::min(4, most);; rank = std::min(rank + 4, most)) {
            Clusters many =
                rank == most ? room.clusters : clustersOf(room, room.clusters.count, rank, stopping);
            size_t floats = many.floats(rank);
            Clusters one = oneSubspace(rows, scale, floats, stopping);
            checkStop();
            std::printf("%7.2f %6d %12.3f %13.3f", (double)floats * 4e-6, rank,
                        100 * compressionError(many, rows, scale, rank), 100 * worstError(many));
            if (one.rank == 0)
                std::printf("     more than %d\n", kMostRank);
            else
                std::printf(" %8d %12.3f %13.3f\n", one.rank,
                            100 * compressionError(one, rows, scale, one.rank), 100 * worstError(one));
            if (rank == most) break;
        }
    }

private:
    const Mesh &mesh;
    Mesh dark = mesh; // with dark lamps
    const TransferSettings &settings;
    const TransferRoom &room;
    int rays;
    Workers &workers;
    const int *stop;
    Relighter relighter{room};
    Lighting lighting;
    const std::vector<TriedSky> skies = bandLimitedSkies(room.bands, room.upIsZ);
    std::vector<std::vector<Rgb>> exact; // the solution for each of `skies`
    std::vector<Rgb> byRows, byClusters;

    void checkStop() const {
        if (__atomic_load_n(stop, __ATOMIC_RELAXED)) throw Stopped();
    }
    // Solves with `count` rays from each site (0: as many as its light needs).
    std::vector<Rgb> solve(const Mesh &model, int count, const Surroundings &surroundings) {
        SolveSettings s = settings.solve;
        s.rays = count;
        s.surroundings = surroundings;
        Solved solved = solveModel(model, s, {}, workers, stop, {});
        checkStop();
        return std::move(solved.solution.light);
    }
    std::vector<Rgb> solveSky(const TriedSky &sky, int count) {
        return solve(dark, count, {sky.sky, sky.suns, {}});
    }
    void relight(const BandLight &light) {
        lighting.sky = light;
        lighting.rank = -1, relighter.relight(lighting, byRows);
        lighting.rank = room.clusters.rank, relighter.relight(lighting, byClusters);
    }
    void printErrors(const std::string &name, const std::vector<Rgb> &solved,
                     const std::vector<Rgb> &others) const {
        std::printf("    %-20s %9.3f %9.3f", name.c_str(), 100 * difference(byRows, solved),
                    100 * difference(byClusters, solved));
        if (!others.empty()) std::printf(" %9.2f", 100 * difference(byRows, others));
        std::printf("\n");
    }
    // The largest error of these clusters' light under `skies`.
    double worstError(const Clusters &c) {
        double worst = 0;
        std::vector<Rgb> light;
        for (size_t i = 0; i < skies.size(); ++i) {
            lighting.sky = skies[i].light, lighting.rank = c.rank;
            relighter.relight(c, lighting, light);
            worst = std::max(worst, difference(light, exact[i]));
        }
        return worst;
    }
    // One subspace for all rows that takes at least `floats` floats; rank 0 if that needs too many axes.
    Clusters oneSubspace(const std::vector<float> &rows, const std::vector<float> &scale, size_t floats,
                         Workers &stopping) const {
        Clusters one;
        one.count = 1, one.columns = room.columns(), one.of.resize(room.texels());
        int rank = 1;
        while (one.floats(rank) < floats) ++rank;
        if (rank > kMostRank) return one;
        return findClusters(rows, one.columns, scale, one.of, {1, rank}, stopping);
    }
};

} // namespace

bool printCheck(const Mesh &mesh, const TransferSettings &settings, const TransferRoom &room, int rays,
                const std::vector<std::string> &skies, Workers &workers, const int *stop) {
    try {
        RoomCheck check(mesh, settings, room, rays, workers, stop);
        std::printf("\nerror against a solution for that light, %% rms   rows  clusters  rows, other rays\n");
        check.printSkies();
        check.printLamps();
        check.printPictures(skies);
        std::printf("\nerror %%                      clusters (CPCA)                    one subspace (PCA)\n"
                    "     MB   rank  of the rows  of the light     rank  of the rows  of the light\n");
        check.printSubspaces();
        std::printf("error of the rows: of the whole matrix (Frobenius); of the light: under the worst sky "
                    "above, rms\n");
        return true;
    } catch (const Stopped &) {
        return false;
    }
}

} // namespace odraz::radiosity
