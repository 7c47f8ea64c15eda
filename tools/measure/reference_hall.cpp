#include "tools/measure/reference_hall.h"

#include "trace/rays/intersect.h"
#include "trace/shade/ball.h"

#include <cmath>

namespace odraz {

SolvedHall::SolvedHall(const RadiositySettings &settings, const Gl &gl, Workers &workers, size_t bytes,
                       const std::function<void(Lights &)> &change, const Progress &progress)
    : memory(bytes), scene(std::make_unique<Scene>()), hall(std::make_unique<Hall>()) {
    double began = processorSeconds();
    prepareHall(*hall, *scene);
    if (change) change(hall->radiosity.lights);
    if (!hall->radiosity.lights.fit())
        throw std::runtime_error("these are more lights than the hall may have");
    if (!solveRadiosity(hall->radiosity, hall->model, *scene, settings, gl, memory.arena, workers, progress))
        throw std::runtime_error("the hall cannot be solved with these settings");
    closeHemicubes(hall->radiosity.hemicubes);
    seconds = processorSeconds() - began;
}

void SolvedHall::polish(const GlossySettings &settings, Arena &arena, Workers &workers) {
    if (!findGlossy(hall->gloss, hall->model, hall->radiosity, hall->floor, hallSettings(*hall).importance,
                    settings, arena, workers))
        throw std::runtime_error("memory is short");
}

namespace {

// Noon without lamps, one lantern, one strip; what arrives of them by the lightmap: where the tracer draws
// what comes directly, without that.
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

// What share of a ball's or the sun's light arrives at a place.
float arrives(const Scene &scene, const Chart &c, Vec3 at, Vec3 from, float radius) {
    Vec3 p = at + c.n * c.off(), to = from - p;
    float far = length(to), cosine = dot(to, c.n) / far;
    float factor = radius > 0 ? ballFormFactor(broadcast(cosine), broadcast(radius * radius / (far * far)))[0]
                              : std::fmax(cosine, 0.f);
    if (factor <= 0) return 0;
    return factor * transmittance(scene, {broadcast(p), broadcast(to * (1 / far))}, broadcast(far * 0.9999f),
                                  kLanes < 1, broadcast(-1))
                        .y[0];
}

} // namespace

std::array<std::vector<Probe>, 3> gatherHall(const SolvedHall &fine, int count, int side, Workers &workers) {
    const Model &m = fine.hall->model;
    const Lights &lights = fine.hall->radiosity.lights;
    std::vector<Probe> places;
    for (const Probe &p : placeProbes(m, count))
        if (maxComponent(fine.scene->mean[m.charts[p.chart].material]) > 0) places.push_back(p);
    Daylight noon = daylightAt(kNoon);
    noon.sky.near = {}; // it is part of the sun
    std::array<std::vector<Probe>, 3> all;
    for (int light = kAtNoon; light <= kByStrip; ++light) {
        Planes planes(*fine.hall, light);
        const Lamp &lamp = lights.lamps[(light == kByStrip ? kStripBasis : kLanternBasis) - kFirstLantern];
        std::vector<Probe> &probes = all[(size_t)light] = places;
        parallelFor(workers, (int)probes.size(), [&](int index, int) {
            Probe &probe = probes[(size_t)index];
            double sum[3] = {};
            auto add = [&](Rgb l) { sum[0] += (double)l.x, sum[1] += (double)l.y, sum[2] += (double)l.z; };
            int backs = castFan(*fine.scene, m.charts[probe.chart], probe.p, side, (uint32_t)index,
                                [&](int chart, Vec3 at, Vec3 d) {
                                    if (chart < 0) {
                                        if (light != kAtNoon) return;
                                        Rgb8 sky = radiance(noon.sky, broadcast(d));
                                        return add({sky.x[0], sky.y[0], sky.z[0]});
                                    }
                                    const Chart &c = m.charts[chart];
                                    Rgb arriving = lightAtProbe(m, planes.plane, {chart, at, {}, false});
                                    // What the tracer draws is sharp: found anew for every place
                                    if (light == kAtNoon)
                                        arriving +=
                                            noon.sunlight * arrives(*fine.scene, c, at, noon.sunAt, 0);
                                    else if (light == kByLantern) {
                                        float share = arrives(*fine.scene, c, at, lamp.centre, lamp.radius);
                                        arriving += Rgb{share, share, share};
                                    }
                                    add(arriving * fine.scene->mean[c.material]);
                                });
            probe.inside = backs > side * side / 20;
            double rays = side * side;
            probe.light = {(float)(sum[0] / rays), (float)(sum[1] / rays), (float)(sum[2] / rays)};
            if (light != kByStrip) return;
            float factor = (float)facetFormFactor(m, *fine.scene, m.charts[lamp.chart].firstFacet,
                                                  m.charts[probe.chart], probe.p, side, (uint32_t)index);
            probe.light += Rgb{factor, factor, factor};
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
