#include "tools/measure/oracle/reference_hall.h"

#include "tools/common/clock.h"

#include <algorithm>
#include <cmath>

namespace odraz {

using namespace radiosity;

SolvedHall::SolvedHall(const RadiositySettings &settings, const Gl &gl, Workers &workers, size_t bytes,
                       const std::function<void(LightBases &)> &change, const Progress &progress)
    : memory(bytes), scene(std::make_unique<Scene>()), hall(std::make_unique<Hall>()) {
    double began = common::processorSeconds();
    prepareHall(*hall, *scene);
    if (change) change(hall->radiosity.bases);
    if (!hall->radiosity.bases.fit())
        throw std::runtime_error("these are more light bases than the hall may have");
    if (!solveRadiosity(hall->radiosity, hall->model, *scene, settings, gl, memory.arena, workers, progress))
        throw std::runtime_error("the hall cannot be solved with these settings");
    closeHemicubes(hall->radiosity.hemicubes);
    seconds = common::processorSeconds() - began;
}

void SolvedHall::polish(Arena &arena, Workers &workers) {
    if (!findGlossy(hall->gloss, hall->model, hall->radiosity, hall->floor, kGlossExponent, arena, workers))
        throw std::runtime_error("memory is short");
}

namespace {

// Three lights: noon without lamps, one lantern, one strip. Only light in the lightmap counts: where the
// tracer itself draws the direct light, that is left out.
enum { kAtNoon, kByLantern, kByStrip };
constexpr int kLanternBasis = kFirstLantern + 1, kStripBasis = kFirstStrip + 3;

struct Planes : TexelPlanes {
    Planes(const Hall &hall, int light) : TexelPlanes(hall.model.texelCount) {
        LightVector v = {};
        if (light == kAtNoon)
            v = lightVector({kNoon, {}, {}, 1});
        else
            v.bounced[light == kByLantern ? kLanternBasis : kStripBasis] = {1, 1, 1};
        if (light == kByStrip) v.direct[kStripBasis] = {1, 1, 1};
        relight(hall.radiosity, hall.model, v, plane);
    }
};

// The share of the sun's light that arrives at a place.
double sunAt(const ModelRays &rays, const Chart &c, Vec3 at, Vec3d towards) {
    double cosine = dot(toDouble(c.n), towards);
    return cosine > 0 && !rays.obstacles.blocked(before(c, at), towards, INFINITY) ? cosine : 0;
}

// The share of a ball's light, by a ray to a random point of the ball.
double ballAt(const ModelRays &rays, const Chart &c, Vec3 at, const Lamp &lamp, Sampler &sampler) {
    Vec3d p = before(c, at), to = toDouble(lamp.centre) - p;
    double far = length(to), radius = (double)lamp.radius, cone = coneOfBall(far, radius);
    Vec3d d = inCone(to / far, cone, {sampler.random(), sampler.random()});
    double cosine = dot(toDouble(c.n), d);
    if (cosine <= 0 || rays.obstacles.blocked(p, d, far - radius)) return 0;
    return cosine * 2 * (1 - cone);
}

} // namespace

std::array<std::vector<Probe>, 3> gatherHall(const SolvedHall &fine, int count, int side, Workers &workers) {
    const Model &m = fine.hall->model;
    const LightBases &bases = fine.hall->radiosity.bases;
    ModelRays rays(m);
    std::vector<Probe> places;
    for (const Probe &p : placeProbes(m, count))
        if (maxComponent(fine.scene->mean[m.charts[p.chart].material]) > 0) places.push_back(p);
    Daylight noon = daylightAt(kNoon);
    noon.sky.near = {}; // the glow near the sun counts as part of the sun
    Vec3d sun = normalize(toDouble(noon.sunAt));
    std::array<std::vector<Probe>, 3> all;
    for (int light = kAtNoon; light <= kByStrip; ++light) {
        Planes planes(*fine.hall, light);
        const Lamp &lamp = bases.lamps[(light == kByStrip ? kStripBasis : kLanternBasis) - kFirstLantern];
        // The light that a ray brings. Direct light that the tracer draws has sharp shadows: it is found anew
        // for every place
        auto brought = [&](int chart, Vec3 at, Vec3 d, Sampler &sampler) -> Rgb {
            if (chart < 0) {
                if (light != kAtNoon) return {};
                Rgb8 sky = radiance(noon.sky, broadcast(d));
                return {sky.x[0], sky.y[0], sky.z[0]};
            }
            const Chart &c = m.charts[chart];
            Rgb arrives = lightAtProbe(m, planes.plane, {chart, at, {}, false});
            if (light == kAtNoon)
                arrives += noon.sunlight * (float)sunAt(rays, c, at, sun);
            else if (light == kByLantern)
                arrives += Rgb{1, 1, 1} * (float)ballAt(rays, c, at, lamp, sampler);
            return arrives * fine.scene->mean[c.material];
        };
        std::vector<Probe> &probes = all[(size_t)light] = places;
        parallelFor(workers, (int)probes.size(), [&](int index, int) {
            Probe &probe = probes[(size_t)index];
            const Chart &c = m.charts[probe.chart];
            Sampler sampler((uint64_t)index, 1);
            Vec3d sum = {};
            int backs = rays.castFan(c, probe.p, side, (uint32_t)index, [&](int chart, Vec3 at, Vec3 d) {
                sum = sum + toDouble(brought(chart, at, d, sampler));
            });
            probe.inside = insideBy(backs, side);
            probe.light = toFloat(sum / (side * side));
            if (light == kByStrip)
                probe.light += Rgb{1, 1, 1} * (float)rays.facetFormFactor(m.charts[lamp.chart].firstFacet, c,
                                                                          probe.p, side, (uint32_t)index);
        });
        dropInside(probes);
    }
    return all;
}

double rmsPercent(const SolvedHall &solved, const std::array<std::vector<Probe>, 3> &probes) {
    double sum = 0;
    for (int light = kAtNoon; light <= kByStrip; ++light) {
        Planes planes(*solved.hall, light);
        double rms = rmsPercent(solved.hall->model, planes.plane, probes[(size_t)light]);
        sum += rms * rms / 3;
    }
    return std::sqrt(sum);
}

} // namespace odraz
