#include "tools/radiosity/reference/mesh_reference.h"

#include "tools/common/statistics.h"
#include "tools/picture/picture_file.h"
#include "tools/radiosity/read/reflectance_picture.h"
#include "tools/radiosity/reference/obstacles.h"
#include "tools/radiosity/reference/sampler.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace odraz::radiosity {

namespace {

// A point with less than this share of the mean light counts as dark: its relative error has no meaning
constexpr double kDark = 1e-3;

Vec3d colour(const std::array<float, 3> &c) { return {(double)c[0], (double)c[1], (double)c[2]}; }
double brightness(Vec3d c) { return (double)luminance(toFloat(c)); }
double maxOf(Vec3d c) { return std::max({c.x, c.y, c.z}); }

std::vector<Obstacles::Triangle> trianglesOf(const Mesh &mesh) {
    std::vector<Obstacles::Triangle> all;
    for (const Triangle &t : mesh.triangles) all.push_back(cornersOf(mesh, t));
    return all;
}

// The index of the first of these ascending sums that exceeds a value.
size_t indexAbove(const std::vector<double> &sums, double value) {
    return std::min((size_t)(std::upper_bound(sums.begin(), sums.end(), value) - sums.begin()),
                    sums.size() - 1);
}

class PathTracer {
public:
    PathTracer(const Mesh &mesh, const Surroundings &surroundings)
        : mesh(mesh), surroundings(surroundings), triangles(trianglesOf(mesh)), obstacles(triangles),
          most(mesh.size() * 1e-5) {
        for (const MeshMaterial &m : mesh.materials)
            if (!m.picture.path.empty()) try {
                    pictures.try_emplace(m.picture.path, m.picture.read());
                } catch (const common::Refused &) { // use the material's Kd, as the solver does
                }
        double sum = 0;
        for (size_t i = 0; i < triangles.size(); ++i) {
            Vec3d e = emitted(i);
            if (!(maxOf(e) > 0)) continue;
            lamps.push_back(i);
            powerSums.push_back(sum += brightness(e) * length(normalOf(mesh, mesh.triangles[i])) / 2);
        }
    }

    // Light by its way to a point.
    struct Arriving {
        Vec3d all, lamps, reflected; // see MeshProbe

        void add(const Arriving &more, double share) {
            all = all + more.all * share, lamps = lamps + more.lamps * share;
            reflected = reflected + more.reflected * share;
        }
    };
    // The light that one path brings to the point p. It starts in cell k of a side x side grid over the
    // hemisphere. `backs` counts first rays that hit a back. `size`: size of the surface around the point.
    Arriving trace(Vec3d p, Vec3d n, double size, int k, int side, Sampler &sampler, int &backs) const {
        Arriving sum = {};
        Vec3d weight = {1, 1, 1};
        auto add = [&](Vec3d light, int depth) {
            sum.all = sum.all + light;
            if (depth > 0) sum.reflected = sum.reflected + light;
        };
        for (int depth = 0;; ++depth) {
            Vec3d from = p + n * std::min(most, size * 1e-2);
            // At its first point, each path samples a different part of the lamps
            double pick = sampler.random();
            if (depth == 0) pick = ((double)((int64_t)k * 7919 % (side * side)) + pick) / (side * side);
            add(weight * direct(from, n, pick, sampler), depth);
            if (depth == 0) sum.lamps = sum.all;
            Vec3d d = byCosine(n, depth == 0 ? inCell(sampler, k, side) : inCell(sampler, 0, 1));
            Obstacles::Hit hit = obstacles.nearest(from, d);
            if (!hit.met()) {
                if (surroundings.sky.width)
                    add(weight * toDouble(surroundings.sky.radiance(toFloat(d))), depth);
                return sum;
            }
            if (hit.back) {
                backs += depth == 0;
                return sum;
            }
            p = from + d * hit.t;
            weight = weight * reflected((size_t)hit.number, p);
            double go = std::min(1., maxOf(weight) * 2); // Russian roulette
            if (!(sampler.random() < go)) return sum;
            weight = weight / go;
            n = normalOf(mesh, mesh.triangles[(size_t)hit.number]), size = std::sqrt(length(n));
            n = normalize(n);
        }
    }

private:
    const Mesh &mesh;
    const Surroundings &surroundings;
    std::vector<Obstacles::Triangle> triangles;
    Obstacles obstacles;
    double most; // largest distance of rays' origins from their surface
    std::vector<size_t> lamps;
    std::vector<double> powerSums;                      // running sums of the lamps' power
    std::map<std::string, ReflectancePicture> pictures; // by path

    // The reflectance of triangle i at a point.
    Vec3d reflected(size_t i, Vec3d p) const {
        const MeshMaterial &m = mesh.materials[(size_t)mesh.triangles[i].material];
        auto picture = pictures.find(m.picture.path);
        if (picture == pictures.end()) return colour(m.reflects);
        const Obstacles::Triangle &t = triangles[i];
        Vec3d n = cross(t[1] - t[0], t[2] - t[0]);
        double share[3], area = dot(n, n), at[2] = {};
        for (size_t k = 0; k < 3; ++k)
            share[k] = dot(cross(t[(k + 1) % 3] - p, t[(k + 2) % 3] - p), n) / area;
        for (size_t k = 0; k < 3; ++k)
            for (size_t c = 0; c < 2; ++c) at[c] += share[k] * (double)mesh.coordinates[i][2 * k + c];
        for (size_t c = 0; c < 2; ++c)
            at[c] = at[c] * (double)m.picture.scale[c] + (double)m.picture.offset[c];
        return colour(m.picture.tint) * toDouble(picture->second.mean({{at[0], at[1]}}, m.picture.clamp));
    }
    Vec3d emitted(size_t i) const { return colour(mesh.materials[(size_t)mesh.triangles[i].material].emits); }
    // The light of a ball, by a ray in a random direction towards it. No other rays hit balls.
    Vec3d directFromBall(const BallLamp &ball, Vec3d p, Vec3d n, Sampler &sampler) const {
        Vec3d to = toDouble(ball.centre) - p;
        double distance = length(to), sine = (double)ball.radius / distance;
        if (!(sine < 1)) return {};
        double least = std::sqrt(1 - sine * sine),
               cosine = 1 - sampler.random() * (sine * sine / (1 + least)),
               across = std::sqrt(std::max(0., 1 - cosine * cosine)),
               turn = 2 * std::numbers::pi * sampler.random();
        Vec3d z = to / distance,
              x = normalize(cross(z, std::fabs(z.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0})),
              y = cross(z, x), d = z * cosine + x * (across * std::cos(turn)) + y * (across * std::sin(turn));
        double facing = dot(d, n);
        if (!(facing > 0) || obstacles.blocked(p, d, distance * 0.9999)) return {};
        // The cone's solid angle is 2 pi (1 - least)
        return toDouble(ball.radiance) * (2 * sine * sine / (1 + least) * facing);
    }
    // The light of suns, of balls, and of one emitting triangle that stands for all others. `pick`, 0 .. 1,
    // selects it by power.
    Vec3d direct(Vec3d p, Vec3d n, double pick, Sampler &sampler) const {
        Vec3d sum = {};
        for (const Sun &sun : surroundings.suns) {
            Vec3d towards = normalize(toDouble(sun.towards));
            if (double c = dot(towards, n); c > 0 && !obstacles.blocked(p, towards, INFINITY))
                sum = sum + toDouble(sun.light) * c;
        }
        for (const BallLamp &ball : surroundings.lamps) sum = sum + directFromBall(ball, p, n, sampler);
        if (lamps.empty()) return sum;
        size_t i = lamps[indexAbove(powerSums, pick * powerSums.back())];
        Vec3d to = onTriangle(triangles[i], inCell(sampler, 0, 1)) - p;
        double distance = length(to), cosine = dot(to, n) / distance,
               lampCosine = -dot(to, normalize(normalOf(mesh, mesh.triangles[i]))) / distance;
        if (!(cosine > 0 && lampCosine > 0) || obstacles.blocked(p, to / distance, distance * (1 - 1e-9)))
            return sum;
        Vec3d e = emitted(i);
        return sum + e * (powerSums.back() / brightness(e) * cosine * lampCosine /
                          (std::numbers::pi * distance * distance));
    }
};

// A triangle of a solution's element.
struct ElementTriangle {
    SolutionPoint corner[3];
    float area;
    int chart, cell;
};

// The triangles of all charts that reflect. Sets `areaSums` to running sums of their area.
std::vector<ElementTriangle> elementTrianglesOf(const Solution &solution, std::vector<double> &areaSums) {
    std::vector<ElementTriangle> all;
    double area = 0;
    solution.forPieces([&](int chart, int cell, const std::vector<SolutionPoint> &piece) {
        if (maxComponent(solution.reflects[(size_t)chart]) <= 0) return;
        for (size_t i = 2; i < piece.size(); ++i) {
            Vec3 u = piece[i - 1].p - piece[0].p, v = piece[i].p - piece[0].p;
            ElementTriangle t = {{piece[0], piece[i - 1], piece[i]}, length(cross(u, v)) / 2, chart, cell};
            all.push_back(t), areaSums.push_back(area += (double)t.area);
        }
    });
    return all;
}

SolutionPoint randomPoint(const ElementTriangle &t, Sampler &sampler) {
    const SolutionPoint *c = t.corner;
    auto a = (float)sampler.random(), b = (float)sampler.random();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    return {c[0].p + (c[1].p - c[0].p) * a + (c[2].p - c[0].p) * b,
            c[0].radiosity + (c[1].radiosity - c[0].radiosity) * a + (c[2].radiosity - c[0].radiosity) * b};
}

} // namespace

std::vector<MeshProbe> placeMeshProbes(const Solution &solution, int count) {
    std::vector<double> areaSums;
    std::vector<ElementTriangle> triangles = elementTrianglesOf(solution, areaSums);
    std::vector<MeshProbe> probes;
    Sampler sampler(1);
    for (int i = 0; i < count && !triangles.empty(); ++i) {
        size_t k = indexAbove(areaSums, (i + sampler.random()) / count * areaSums.back());
        SolutionPoint found = randomPoint(triangles[k], sampler);
        auto chart = (size_t)triangles[k].chart;
        // The light that arrives is radiosity minus emission, divided by reflectance
        Rgb leaves = found.radiosity - solution.emits[chart], r = solution.reflectsOf(triangles[k].cell);
        // For a colour that is not reflected, take the interpolated light
        Rgb light = solution.lightAt((int)chart, found.p);
        auto share = [](float x, float y, float other) { return y > 0 ? x / y : other; };
        Rgb arrives = {share(leaves.x, r.x, light.x), share(leaves.y, r.y, light.y),
                       share(leaves.z, r.z, light.z)};
        const Chart &c = solution.charts[chart];
        probes.push_back({(int)chart, found.p, c.n, arrives, {}, {}, {}, 0, 0, c.width + c.height});
    }
    return probes;
}

void solvedAt(const Solution &solution, std::vector<MeshProbe> &probes) {
    for (MeshProbe &p : probes) p.solved = solution.lightAt(p.chart, p.p);
}

void tracePaths(const Mesh &mesh, const Surroundings &surroundings, std::vector<MeshProbe> &probes, int side,
                Workers &workers, const int *stop) {
    int paths = side * side;
    PathTracer tracer(mesh, surroundings);
    std::vector<uint8_t> inside(probes.size());
    parallelFor(workers, (int)probes.size(), [&](int i, int) {
        if (stop && __atomic_load_n(stop, __ATOMIC_RELAXED)) return;
        MeshProbe &probe = probes[(size_t)i];
        Sampler sampler((uint64_t)i);
        Vec3d p = toDouble(probe.p), normal = toDouble(probe.n);
        int backs = 0;
        // Trace two independent sets of paths: their difference is the noise
        PathTracer::Arriving means[2] = {}, mean = {};
        for (PathTracer::Arriving &one : means) {
            for (int k = 0; k < paths; ++k)
                one.add(tracer.trace(p, normal, (double)probe.size, k, side, sampler, backs), 1. / paths);
            mean.add(one, 0.5);
        }
        auto noise2 = [](Vec3d a, Vec3d b) { return std::pow(brightness(a) - brightness(b), 2) / 4; };
        probe.traced = toFloat(mean.all), probe.lamps = toFloat(mean.lamps);
        probe.reflected = toFloat(mean.reflected);
        probe.noise2 = noise2(means[0].all, means[1].all);
        probe.reflectedNoise2 = noise2(means[0].reflected, means[1].reflected);
        inside[(size_t)i] = backs > paths / 2;
    });
    size_t kept = 0;
    for (size_t i = 0; i < probes.size(); ++i)
        if (!inside[i]) probes[kept++] = probes[i];
    probes.resize(kept);
}

MeshErrors errorsOf(const std::vector<float> &values, const std::vector<float> &reference, double noise2) {
    std::vector<float> relative;
    double error = 0, all = 0, solved = 0, traced = 0;
    for (float b : reference) traced += (double)b;
    const double dark = kDark * traced / (double)std::max(reference.size(), (size_t)1);
    for (size_t i = 0; i < values.size(); ++i) {
        double a = (double)values[i], b = (double)reference[i];
        if (b > dark) relative.push_back((float)(std::fabs(a - b) / b));
        error += (a - b) * (a - b), all += b * b;
        solved += a;
    }
    if (relative.empty()) {
        double none = error == 0 && !values.empty() ? 0 : NAN;
        return {none, none, none, NAN, NAN};
    }
    return {100 * (double)common::quantile(relative, 0.5), 100 * (double)common::quantile(relative, 0.95),
            100 * std::sqrt(std::max(0., error - noise2) / all), 100 * (solved / traced - 1),
            100 * std::sqrt(noise2 / all)};
}

MeshErrors errorsOf(const std::vector<MeshProbe> &probes) {
    std::vector<float> values, reference;
    double noise2 = 0;
    for (const MeshProbe &p : probes) {
        values.push_back(luminance(p.solved)), reference.push_back(luminance(p.traced));
        noise2 += p.noise2;
    }
    return errorsOf(values, reference, noise2);
}

} // namespace odraz::radiosity
