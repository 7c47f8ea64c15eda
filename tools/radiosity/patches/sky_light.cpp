#include "tools/radiosity/patches/patch_solver.h"

#include "radiosity/visible.h"
#include "trace/rays/intersect.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace odraz::radiosity {

namespace {

constexpr double kPiD = 3.14159265358979;

// Directions about the normal, in four rounds. Each round has every fourth cell of a grid, mapped to the disc
// without distorting squares much (Shirley and Chiu, 1997) and lifted to the hemisphere.
struct Rounds {
    std::vector<Vec3> directions[4];

    explicit Rounds(int rays) { // the square of an even number
        int across = (int)std::lround(std::sqrt(rays));
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i) {
                double a = 2 * (i + 0.5) / across - 1, b = 2 * (j + 0.5) / across - 1, r, angle;
                if (std::fabs(a) > std::fabs(b))
                    r = a, angle = kPiD / 4 * (b / a);
                else
                    r = b, angle = kPiD / 2 - (b != 0 ? kPiD / 4 * (a / b) : 0);
                directions[(i & 1) + 2 * (j & 1)].push_back({(float)(r * std::cos(angle)),
                                                             (float)(r * std::sin(angle)),
                                                             (float)std::sqrt(std::max(1 - r * r, 0.))});
            }
    }
};

// Adds the sky's light to up to 8 texels: first .. first + count.
void addTo(const Model &model, const Scene &scene, const SkyPicture &sky, const Rounds &rounds, int first,
           int count, float *const *direct) {
    int numbers[8], seen[8] = {};
    Float8 cosine, sine;
    for (int k = 0; k < 8; ++k) {
        numbers[k] = first + std::min(k, count - 1);
        if (k < count) seen[k] = model.texels[numbers[k]].visible;
        uint32_t hash = (uint32_t)numbers[k] * 2654435761u;
        float turn = (float)(hash >> 8) * (float)(2 * kPiD / (1 << 24));
        cosine[k] = std::cos(turn), sine[k] = std::sin(turn);
    }
    Texels8 t = loadTexels(model, numbers, count);
    Vec3x8 u = t.u * cosine + t.v * sine, v = t.v * cosine - t.u * sine;
    Rgb sums[8] = {};
    float looked[8] = {};
    for (int round = 0; round < 4; ++round) {
        Places8 places = placesOf(seen, round);
        if (!any(places.active)) break;
        Vec3x8 from = t.at(places.x, places.y);
        for (const Vec3 &local : rounds.directions[round]) {
            Vec3x8 d = u * broadcast(local.x) + v * broadcast(local.y) + t.n * broadcast(local.z);
            Float8 open = transmittance(scene, {from, d}, broadcast(kFar), places.active, broadcast(-1)).y;
            for (int k = 0; k < count; ++k) {
                if (!places.active[k]) continue;
                looked[k] += 1;
                if (open[k] > 0) sums[k] = sums[k] + sky.radiance({d.x[k], d.y[k], d.z[k]}) * open[k];
            }
        }
    }
    for (int k = 0; k < count; ++k) {
        Rgb mean = sums[k] * (1 / std::max(looked[k], 1.f));
        direct[0][first + k] += mean.x, direct[1][first + k] += mean.y, direct[2][first + k] += mean.z;
    }
}

} // namespace

void PatchSolver::addSky() {
    static const Rounds rounds(1024);
    parallelRanges(task.workers, m.texelCount, 64, [&](int first, int end, int) {
        for (int i = first; i < end; i += 8)
            addTo(m, *p.scene, s.surroundings.sky, rounds, i, std::min(end - i, 8), r.direct);
    });
}

} // namespace odraz::radiosity
