#include "reference_hall.h"

#include "trace/ball.h"
#include "trace/intersect.h"

#include <cmath>

namespace odraz {

SolvedHall::SolvedHall(const RadiositySettings &settings, const Gl &gl, Workers &workers, size_t bytes)
    : memory(new unsigned char[bytes + 64]()), scene(std::make_unique<Scene>()),
      hall(std::make_unique<Hall>()) {
    Arena arena = {memory.get() + (64 - (uintptr_t)memory.get() % 64), bytes, 0};
    double began = processorSeconds();
    prepareHall(*hall, *scene);
    if (!solveRadiosity(hall->radiosity, hall->model, *scene, settings, gl, arena, workers, {}))
        throw std::runtime_error("the hall cannot be solved with these settings");
    closeHemicubes(hall->radiosity.hemicubes);
    seconds = processorSeconds() - began;
}

namespace {

// All of a basis that arrives by the lightmap: where the tracer draws what comes directly, without that.
struct Planes {
    std::vector<float> sum[3];
    float *plane[3];
    Planes(const Hall &hall, int basis, bool direct) {
        size_t count = (size_t)hall.model.texelCount;
        for (int c = 0; c < 3; ++c) {
            const float *bounced = hall.radiosity.bounced[basis][c], *own = hall.radiosity.direct[basis];
            for (size_t i = 0; i < count; ++i) sum[c].push_back(bounced[i] + (direct ? own[i] : 0));
            sum[c].resize(count + 8);
            plane[c] = sum[c].data();
        }
    }
};

bool drawnByTracer(int basis) { return basis < kHours + kLanterns; }

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
    std::array<std::vector<Probe>, 3> all;
    for (size_t b = 0; b < 3; ++b) {
        int basis = kHallBases[b];
        Planes planes(*fine.hall, basis, !drawnByTracer(basis));
        std::vector<Probe> &probes = all[b] = places;
        parallelFor(workers, (int)probes.size(), [&](int index, int) {
            Probe &probe = probes[(size_t)index];
            double sum[3] = {};
            auto add = [&](Rgb l) { sum[0] += (double)l.x, sum[1] += (double)l.y, sum[2] += (double)l.z; };
            int backs = castFan(*fine.scene, m.charts[probe.chart], probe.p, side, (uint32_t)index,
                                [&](int chart, Vec3 at, Vec3 d) {
                                    if (chart < 0) {
                                        if (basis >= kHours) return;
                                        Rgb8 sky = radiance(lights.skies[basis].sky, broadcast(d));
                                        return add({sky.x[0], sky.y[0], sky.z[0]});
                                    }
                                    const Chart &c = m.charts[chart];
                                    Rgb light = lightAtProbe(m, planes.plane, {chart, at, {}, false});
                                    // What the tracer draws is sharp: found anew for every place
                                    if (basis < kHours)
                                        light += lights.skies[basis].sunlight *
                                                 arrives(*fine.scene, c, at, lights.skies[basis].sunAt, 0);
                                    else if (drawnByTracer(basis)) {
                                        const Lamp &lamp = lights.lamps[basis - kHours];
                                        float share = arrives(*fine.scene, c, at, lamp.centre, lamp.radius);
                                        light += Rgb{share, share, share};
                                    }
                                    add(light * fine.scene->mean[c.material]);
                                });
            probe.inside = backs > side * side / 20;
            double rays = side * side;
            probe.light = {(float)(sum[0] / rays), (float)(sum[1] / rays), (float)(sum[2] / rays)};
            if (drawnByTracer(basis)) return;
            const Chart &lamp = m.charts[lights.lamps[basis - kHours].chart];
            float factor = (float)facetFormFactor(m, *fine.scene, lamp.firstFacet, m.charts[probe.chart],
                                                  probe.p, side, (uint32_t)index);
            probe.light += Rgb{factor, factor, factor};
        });
        dropInside(probes);
    }
    return all;
}

double rmsPercent(const SolvedHall &solved, const std::array<std::vector<Probe>, 3> &probes) {
    double sum = 0;
    for (size_t b = 0; b < 3; ++b) {
        Planes planes(*solved.hall, kHallBases[b], !drawnByTracer(kHallBases[b]));
        double rms = rmsPercent(solved.hall->model, planes.plane, probes[b]);
        sum += rms * rms / 3;
    }
    return std::sqrt(sum);
}

} // namespace odraz
