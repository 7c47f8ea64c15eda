#include "tools/measure/mesh_reference.h"

#include "base/random.h"
#include "tools/common/statistics.h"
#include "tools/radiosity/bright.h"
#include "tools/radiosity/light_grid.h"

#include <algorithm>
#include <cmath>

namespace odraz {

namespace {

struct Random {
    uint32_t state;
    float operator()() { return unitFloat(state = pcg(state)); }
};

Vec3 cosineDirection(const Vec3 &n, float u, float turn) {
    float t = turn * 6.2831853f, r = std::sqrt(u);
    Vec3 a = normalize(cross(std::fabs(n.y) < 0.9f ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, n)), b = cross(n, a);
    return a * (r * std::cos(t)) + b * (r * std::sin(t)) + n * std::sqrt(std::max(0.f, 1 - u));
}

class Paths {
public:
    Paths(const Mesh &mesh, const Surroundings &around)
        : mesh(mesh), around(around), corners(cornersOf(mesh)), tree(corners),
          off((float)mesh.size() * 1e-5f) {
        double sum = 0;
        for (size_t i = 0; i < corners.size(); ++i) {
            Rgb e = emitted(i);
            if (!(maxComponent(e) > 0)) continue;
            lamps.push_back(i);
            until.push_back(sum += (double)(bright(e) * area(i)));
        }
    }

    // What arrives at a place by one path; `backs` counts first rays that meet one.
    // It sets out in cell k of a side x side grid over the hemisphere.
    Rgb trace(Vec3 p, Vec3 n, int k, int side, Random &random, int &backs) const {
        Rgb sum = {}, weight = {1, 1, 1};
        for (int depth = 0;; ++depth) {
            Vec3 from = p + n * off;
            // The first time every path takes another part of the lamps
            float pick = random();
            if (depth == 0) pick = ((float)((int64_t)k * 7919 % (side * side)) + pick) / (float)(side * side);
            sum += weight * direct(from, n, pick, random);
            float u = random(), turn = random();
            if (depth == 0)
                u = ((float)(k % side) + u) / (float)side, turn = ((float)(k / side) + turn) / (float)side;
            Vec3 d = cosineDirection(n, u, turn);
            RayHit hit = tree.nearest(from, d);
            if (hit.triangle < 0) {
                if (around.sky.width) sum += weight * around.sky.radiance(d);
                return sum;
            }
            if (hit.back) {
                backs += depth == 0;
                return sum;
            }
            const auto &r = mesh.materials[(size_t)mesh.triangles[(size_t)hit.triangle].material].reflects;
            weight = weight * Rgb{r[0], r[1], r[2]};
            float go = std::min(1.f, maxComponent(weight) * 2); // Russian roulette
            if (!(random() < go)) return sum;
            weight = weight * (1 / go);
            p = from + d * hit.t;
            n = normalOf((size_t)hit.triangle);
        }
    }

private:
    const Mesh &mesh;
    const Surroundings &around;
    std::vector<RayTree::Corners> corners;
    RayTree tree;
    float off;
    std::vector<size_t> lamps;
    std::vector<double> until;

    Rgb emitted(size_t i) const {
        const auto &e = mesh.materials[(size_t)mesh.triangles[i].material].emits;
        return {e[0], e[1], e[2]};
    }
    float area(size_t i) const {
        const auto &c = corners[i];
        return length(cross(c[1] - c[0], c[2] - c[0])) / 2;
    }
    Vec3 normalOf(size_t i) const {
        const auto &c = corners[i];
        return normalize(cross(c[1] - c[0], c[2] - c[0]));
    }
    Rgb direct(const Vec3 &p, const Vec3 &n, float pick, Random &random) const {
        Rgb sum = {};
        for (const Sun &sun : around.suns)
            if (float c = dot(sun.towards, n); c > 0 && !tree.blocked(p, sun.towards, kInfinity))
                sum += sun.light * c;
        if (lamps.empty()) return sum;
        size_t k = (size_t)(std::upper_bound(until.begin(), until.end(), (double)pick * until.back()) -
                            until.begin());
        size_t i = lamps[std::min(k, lamps.size() - 1)];
        float a = random(), b = random();
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const auto &c = corners[i];
        Vec3 to = c[0] + (c[1] - c[0]) * a + (c[2] - c[0]) * b - p;
        float far = length(to), here = dot(to, n) / far, there = -dot(to, normalOf(i)) / far;
        if (!(here > 0 && there > 0) || tree.blocked(p, to * (1 / far), far * 0.9999f)) return sum;
        Rgb e = emitted(i);
        return sum + e * ((float)until.back() / bright(e) * here * there / (3.14159265f * far * far));
    }
};

} // namespace

std::vector<MeshProbe> placeMeshProbes(const Baked &baked, int count, bool middles) {
    struct Part {
        BakedPoint corner[3];
        float area;
        int chart, cell;
    };
    std::vector<Part> parts;
    std::vector<double> until;
    double area = 0;
    baked.forPieces([&](int chart, int cell, const std::vector<BakedPoint> &piece) {
        if (maxComponent(baked.reflects[(size_t)chart]) <= 0) return;
        for (size_t i = 2; i < piece.size(); ++i) {
            Vec3 u = piece[i - 1].p - piece[0].p, v = piece[i].p - piece[0].p;
            Part part = {{piece[0], piece[i - 1], piece[i]}, length(cross(u, v)) / 2, chart, cell};
            parts.push_back(part), until.push_back(area += (double)part.area);
        }
    });
    std::vector<MeshProbe> probes;
    Random random = {1};
    auto put = [&](int chart, const Vec3 &p, const Rgb &radiosity) {
        Rgb shown = radiosity - baked.emits[(size_t)chart], r = baked.reflects[(size_t)chart];
        auto share = [](float x, float y) { return y > 0 ? x / y : 0; };
        probes.push_back({chart,
                          p,
                          baked.charts[(size_t)chart].n,
                          {share(shown.x, r.x), share(shown.y, r.y), share(shown.z, r.z)},
                          {},
                          0});
    };
    for (int i = 0; i < count && !parts.empty(); ++i) {
        double at = (i + (double)random()) / count * area;
        auto k = std::min((size_t)(std::upper_bound(until.begin(), until.end(), at) - until.begin()),
                          parts.size() - 1);
        const BakedPoint *c = parts[k].corner;
        if (!middles) {
            float a = random(), b = random();
            if (a + b > 1) a = 1 - a, b = 1 - b;
            put(parts[k].chart, c[0].p + (c[1].p - c[0].p) * a + (c[2].p - c[0].p) * b,
                c[0].radiosity + (c[1].radiosity - c[0].radiosity) * a +
                    (c[2].radiosity - c[0].radiosity) * b);
            continue;
        }
        // An element's parts follow one another
        size_t first = k, end = k + 1;
        while (first > 0 && parts[first - 1].cell == parts[k].cell) --first;
        while (end < parts.size() && parts[end].cell == parts[k].cell) ++end;
        Vec3 p = {};
        Rgb radiosity = {};
        float all = 0;
        for (size_t j = first; j < end; ++j)
            for (const BakedPoint &corner : parts[j].corner) {
                p += corner.p * parts[j].area, radiosity += corner.radiosity * parts[j].area;
                all += parts[j].area;
            }
        put(parts[k].chart, p * (1 / all), radiosity * (1 / all));
    }
    return probes;
}

void solvedAt(const Baked &baked, std::vector<MeshProbe> &probes) {
    for (MeshProbe &p : probes) p.solved = baked.lightAt(p.chart, p.p);
}

void tracePaths(const Mesh &mesh, const Surroundings &around, std::vector<MeshProbe> &probes, int side,
                Workers &workers) {
    int paths = side * side;
    Paths tracer(mesh, around);
    std::vector<uint8_t> inside(probes.size());
    parallelFor(workers, (int)probes.size(), [&](int i, int) {
        MeshProbe &probe = probes[(size_t)i];
        Random random = {pcg((uint32_t)i + 77)};
        int backs = 0;
        // Two sets that know nothing of each other: how far apart they are tells the noise
        Rgb means[2];
        for (Rgb &mean : means) {
            double sum[3] = {};
            for (int k = 0; k < paths; ++k) {
                Rgb l = tracer.trace(probe.p, probe.n, k, side, random, backs);
                sum[0] += (double)l.x, sum[1] += (double)l.y, sum[2] += (double)l.z;
            }
            mean = {(float)(sum[0] / paths), (float)(sum[1] / paths), (float)(sum[2] / paths)};
        }
        probe.traced = (means[0] + means[1]) * 0.5f;
        double apart = (double)bright(means[0]) - (double)bright(means[1]);
        probe.noise2 = apart * apart / 4;
        inside[(size_t)i] = backs > paths / 2;
    });
    size_t kept = 0;
    for (size_t i = 0; i < probes.size(); ++i)
        if (!inside[i]) probes[kept++] = probes[i];
    probes.resize(kept);
}

MeshErrors errorsOf(const std::vector<MeshProbe> &probes) {
    std::vector<float> relative;
    double error = 0, all = 0, solved = 0, traced = 0, noise = 0;
    for (const MeshProbe &p : probes) {
        double a = (double)bright(p.solved), b = (double)bright(p.traced);
        relative.push_back((float)(std::fabs(a - b) / std::max(b, 1e-12)));
        error += (a - b) * (a - b), all += b * b, noise += p.noise2;
        solved += a, traced += b;
    }
    return {100 * (double)quantile(relative, 0.5), 100 * (double)quantile(relative, 0.95),
            100 * std::sqrt(std::max(0., error - noise) / all), 100 * (solved / traced - 1),
            100 * std::sqrt(noise / all)};
}

} // namespace odraz
