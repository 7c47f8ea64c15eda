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

constexpr int kPictureRows = 512;

// A lobe around a direction, as wide as a cosine to the power of `exponent`.
void addLobe(BandLight &to, int bands, const Vec3 &towards, float exponent, const Rgb &colour) {
    Float8 y[kMostSh];
    evaluateBands(broadcast(normalize(towards)), bands, y);
    for (int k = 0; k < bands * bands; ++k) to[(size_t)k] += colour * (y[k][0] * window(bandOf(k), exponent));
}

std::vector<Rgb> fresh(const Mesh &mesh, const TransferSettings &s, int rays, const Surroundings &around,
                       Workers &workers, const int *stop) {
    SolveSettings settings = s.solve;
    settings.rays = rays;
    settings.surroundings = around;
    return solveModel(mesh, settings, {}, workers, stop, {}).solution.light;
}

void printErrors(const std::string &name, const std::vector<Rgb> &rows, const std::vector<Rgb> &clusters,
                 const std::vector<Rgb> &exact, const std::vector<Rgb> *others) {
    std::printf("    %-20s %9.3f %9.3f", name.c_str(), 100 * difference(rows, exact),
                100 * difference(clusters, exact));
    if (others) std::printf(" %9.2f", 100 * difference(rows, *others));
    std::printf("\n");
}

} // namespace

std::vector<TriedSky> bandLimitedSkies(int bands, bool upIsZ) {
    auto place = [&](float x, float y, float z) { return asInModel({x, y, z}, upIsZ); };
    std::vector<TriedSky> all(5);
    const char *names[] = {"even", "gradient", "glow", "two lights", "random"};
    auto even = (float)std::sqrt(4 * std::numbers::pi);
    for (size_t i = 0; i < all.size(); ++i) {
        all[i].name = names[i];
        all[i].light = {};
        all[i].light[0] = Rgb{0.7f, 0.8f, 1} * even;
    }
    addLobe(all[1].light, std::min(bands, 2), place(0, 1, 0), 1e6f, {1.5f, 1.7f, 2});
    addLobe(all[2].light, bands, place(0.8f, 0.35f, -0.5f), 12, {20, 12, 5});
    addLobe(all[3].light, bands, place(-0.6f, 0.7f, 0.4f), 12, {3, 6, 12});
    addLobe(all[3].light, bands, place(0.5f, 0.2f, 0.9f), 12, {14, 4, 2});
    for (int k = 1; k < bands * bands; ++k)
        for (int c = 0; c < 3; ++c) {
            float random = unitFloat(pcg((uint32_t)(3 * k + c))) - 0.5f;
            (c == 0   ? all[4].light[(size_t)k].x
             : c == 1 ? all[4].light[(size_t)k].y
                      : all[4].light[(size_t)k].z) = 2 * random;
        }
    for (TriedSky &s : all) s.sky = pictureOf(s.light, bands, upIsZ);
    return all;
}

SkyPicture pictureOf(const BandLight &light, int bands, bool upIsZ) {
    SkyPicture sky = {2 * kPictureRows, kPictureRows, {}, upIsZ};
    for (int j = 0; j < sky.height; ++j)
        for (int first = 0; first < sky.width; first += 8) {
            double down = std::numbers::pi * (j + 0.5) / sky.height;
            Vec3x8 d;
            for (int k = 0; k < 8; ++k) {
                double around = 2 * std::numbers::pi * ((first + k + 0.5) / sky.width - 0.5);
                Vec3 q = asInModel({(float)(std::sin(down) * std::sin(around)), (float)std::cos(down),
                                    (float)(-std::sin(down) * std::cos(around))},
                                   upIsZ);
                d.x[k] = q.x, d.y[k] = q.y, d.z[k] = q.z;
            }
            Float8 y[kMostSh];
            evaluateBands(d, bands, y);
            Rgb8 sum = {};
            for (int k = 0; k < bands * bands; ++k) sum = fmadd(broadcast(light[(size_t)k]), y[k], sum);
            for (int k = 0; k < 8; ++k) sky.pixels.push_back({sum.x[k], sum.y[k], sum.z[k]});
        }
    return sky;
}

// A solution for a sky alone, with dark lamps: by the room's rays, or with rays == 0 by the number of rays
// that this light needs. A value other than 0 in `stop` ends it early, with incomplete light.
static std::vector<Rgb> freshLight(const Mesh &mesh, const TransferSettings &settings, int rays,
                                   const TriedSky &sky, Workers &workers, const int *stop) {
    Mesh dark = mesh;
    for (MeshMaterial &m : dark.materials) m.emits = {};
    return fresh(dark, settings, rays, {sky.sky, sky.suns, {}}, workers, stop);
}

// A solution for the model's lamps alone.
static std::vector<Rgb> freshLamps(const Mesh &mesh, const TransferSettings &settings, int rays,
                                   Workers &workers, const int *stop) {
    return fresh(mesh, settings, rays,
                 {{}, settings.solve.surroundings.suns, settings.solve.surroundings.lamps}, workers, stop);
}

double difference(const std::vector<Rgb> &a, const std::vector<Rgb> &b) {
    double lost = 0, all = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        Rgb d = a[i] - b[i];
        lost += (double)dot(d, d), all += (double)dot(b[i], b[i]);
    }
    return all > 0 ? std::sqrt(lost / all) : lost > 0 ? INFINITY : 0;
}

// One subspace for all rows of a room, with the fewest axes that take as much memory as `floats`; without
// axes if these are more than kMostRank.
static Clusters oneSubspace(const TransferRoom &room, const std::vector<float> &rows,
                            const std::vector<float> &scale, size_t floats, Workers &workers) {
    Clusters one = {.count = 1,
                    .rank = 0,
                    .columns = room.columns(),
                    .of = std::vector<int>(room.texels()),
                    .axes = {},
                    .weights = {}};
    int rank = 1;
    while (one.floats(rank) < floats) ++rank;
    if (rank > kMostRank) return one;
    return findClusters(rows, one.columns, scale, one.of, 1, rank, workers);
}

bool printCheck(const Mesh &mesh, const TransferSettings &settings, const TransferRoom &room, int rays,
                const std::vector<std::string> &skies, Workers &workers, const int *stop) {
    auto stopped = [stop] { return __atomic_load_n(stop, __ATOMIC_RELAXED) != 0; };
    Relighter relighter(room);
    std::vector<Rgb> rows, clusters, shown;
    Lighting lighting = {
        .sky = {}, .lamps = std::vector<float>(room.lamps.size()), .bands = room.bands, .rank = -1};
    auto relight = [&](const BandLight &light) {
        lighting.sky = light;
        lighting.rank = -1, relighter.relight(lighting, rows);
        lighting.rank = room.clusters.rank, relighter.relight(lighting, clusters);
    };
    std::printf("\nerror against a solution for that light, %% rms   rows  clusters  rows, other rays\n");
    std::vector<TriedSky> tried = bandLimitedSkies(room.bands, room.upIsZ);
    std::vector<std::vector<Rgb>> exact;
    for (const TriedSky &sky : tried) {
        exact.push_back(freshLight(mesh, settings, rays, sky, workers, stop));
        relight(sky.light);
        std::vector<Rgb> others; // slow, so not for all skies
        if (exact.size() % 2) others = freshLight(mesh, settings, 0, sky, workers, stop);
        if (stopped()) return false;
        printErrors(sky.name, rows, clusters, exact.back(), others.empty() ? nullptr : &others);
    }
    if (!room.lamps.empty()) {
        std::fill(lighting.lamps.begin(), lighting.lamps.end(), 1.f);
        relight({});
        std::vector<Rgb> lit = freshLamps(mesh, settings, rays, workers, stop);
        if (stopped()) return false;
        printErrors("all lamps", rows, clusters, lit, nullptr);
        std::fill(lighting.lamps.begin(), lighting.lamps.end(), 0.f);
    }
    for (const std::string &path : skies) {
        std::vector<std::string> notes;
        Projected projected = readEnvironment(path, room.upIsZ, &notes);
        TriedSky sky = {path.substr(path.rfind('/') + 1), projected.light, {}, {}};
        sky.sky = readSky(path, room.upIsZ, sky.suns);
        relight(sky.light);
        std::vector<Rgb> lit = freshLight(mesh, settings, rays, sky, workers, stop);
        if (stopped()) return false;
        printErrors(sky.name, rows, clusters, lit, nullptr);
        notes.push_back(bandLossText(sky.name, projected, room.bands));
        for (const std::string &note : notes) std::printf("        (%s)\n", note.c_str());
    }

    // As in the lecture: the same number of stored floats, in one subspace or in one for each cluster
    std::printf("\nerror %%                      clusters (CPCA)                    one subspace (PCA)\n"
                "     MB   rank  of the rows  of the light     rank  of the rows  of the light\n");
    std::vector<float> matrix = room.rows(), scale = columnScale(room, matrix);
    auto worst = [&](const Clusters &c) {
        double most = 0;
        for (size_t i = 0; i < tried.size(); ++i) {
            lighting.sky = tried[i].light, lighting.rank = c.rank;
            relighter.relight(c, lighting, shown);
            most = std::max(most, difference(shown, exact[i]));
        }
        return most;
    };
    std::vector<int> ranks;
    for (int rank = 4; rank < room.clusters.rank; rank += 4) ranks.push_back(rank);
    ranks.push_back(room.clusters.rank);
    Workers stopping = workers;
    stopping.abort = stop;
    for (int rank : ranks) {
        Clusters many = room.clusters;
        if (rank != many.rank)
            many = findClusters(matrix, room.columns(), scale, blocksOf(room.model, many.count), many.count,
                                rank, stopping);
        if (stopped()) return false;
        size_t floats = many.floats(rank);
        std::printf("%7.2f %6d %12.3f %13.3f", (double)floats * 4e-6, rank,
                    100 * compressionError(many, matrix, scale, rank), 100 * worst(many));
        Clusters one = oneSubspace(room, matrix, scale, floats, stopping);
        if (stopped()) {
            std::printf("\n"); // ends the row
            return false;
        }
        if (one.rank == 0)
            std::printf("     more than %d\n", kMostRank);
        else
            std::printf(" %8d %12.3f %13.3f\n", one.rank,
                        100 * compressionError(one, matrix, scale, one.rank), 100 * worst(one));
    }
    std::printf(
        "of the rows: of the whole matrix (Frobenius); of the light: the worst of the skies above, rms\n");
    return true;
}

} // namespace odraz::radiosity
