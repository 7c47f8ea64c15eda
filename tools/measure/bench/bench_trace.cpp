// bench_trace: how fast the tracer is, by kind of ray and by picture.
//
//   build/bench_trace --benchmark_filter='^ray'      rays and points a second
//   build/bench_trace --benchmark_filter=picture     milliseconds of processor time a picture of 1280x720:
//                                                    posing it, tracing it, developing it, all of it
#include "tools/measure/bench/subject.h"

#include "trace/shade/whitted.h"
#include "trace/texture/noise.h"

#include <benchmark/benchmark.h>
#include <map>
#include <random>

using namespace odraz;
using namespace odraz::measure;

namespace {

Subject &subject(const std::string &name) {
    static std::map<std::string, std::unique_ptr<Subject>> all;
    auto &s = all[name];
    if (!s) s = std::make_unique<Subject>(findSubject(name), 1280, 720);
    return *s;
}

// Rays of the middle of a picture: primary rays row by row, and what they hit.
struct Rays {
    std::vector<Ray8> primary, mirrored;
    std::vector<Hit8> hits;
    Candidates among;

    explicit Rays(Subject &s) {
        const View &v = s.view();
        findCandidates(s.scene(),
                       beamThrough(v.eye, {v.direction(608.f, 328.f), v.direction(674.f, 328.f),
                                           v.direction(674.f, 394.f), v.direction(608.f, 394.f)}),
                       among);
        for (int y = 330; y < 392; ++y)
            for (int x = 610; x < 672; x += 8) {
                Ray8 r = {broadcast(v.eye),
                          normalize(v.direction(toFloat(kLanes) + (float)x, broadcast((float)y)))};
                Hit8 hit = intersect(s.scene(), r, kLanes >= 0);
                primary.push_back(r);
                hits.push_back(hit);
                if (any(hit.shape < 0)) continue;
                // Mirrored where the primary rays hit
                Ray8 m = r;
                const Shape &shape = s.scene().shapes[hit.shape[0]];
                Surface8 at = surfaceAt(shape, r, hit.t);
                m.o = offsetOrigin(shape, at, broadcast(1.f));
                m.d = normalize(fmadd(at.n, dot(at.n, r.d) * -2.f, r.d));
                mirrored.push_back(m);
            }
    }
};

template <class F> void count(benchmark::State &state, size_t packets, F &&f) {
    size_t i = 0;
    for (auto _ : state) {
        f(i);
        if (++i == packets) i = 0;
    }
    state.SetItemsProcessed((int64_t)state.iterations() * 8);
}

void registerRays(const std::string &name) {
    auto with = [&](const std::string &kind, auto &&f) {
        benchmark::RegisterBenchmark(("ray/" + kind + "/" + name).c_str(), [=](benchmark::State &state) {
            Subject &s = subject(name);
            Rays rays(s);
            f(state, s, rays);
        });
    };
    with("primary of a beam", [](benchmark::State &state, Subject &s, Rays &r) {
        if (r.among.count < 0) return state.SkipWithError("too many candidates for a beam");
        count(state, r.primary.size(), [&](size_t i) {
            benchmark::DoNotOptimize(
                intersect(s.scene(), r.among, s.view().eye, r.primary[i].d, kLanes >= 0));
        });
    });
    with("primary in packets", [](benchmark::State &state, Subject &s, Rays &r) {
        count(state, r.primary.size(),
              [&](size_t i) { benchmark::DoNotOptimize(intersect(s.scene(), r.primary[i], kLanes >= 0)); });
    });
    with("mirrored", [](benchmark::State &state, Subject &s, Rays &r) {
        if (r.mirrored.empty()) return state.SkipWithError("no ray hits anything there");
        count(state, r.mirrored.size(),
              [&](size_t i) { benchmark::DoNotOptimize(intersect(s.scene(), r.mirrored[i], kLanes >= 0)); });
    });
    with("shadow", [](benchmark::State &state, Subject &s, Rays &r) {
        Vec3 light = s.scene().lights[0].position;
        count(state, r.primary.size(), [&](size_t i) {
            Vec3x8 to = fmadd(r.primary[i].d, min(r.hits[i].t, 100.f), r.primary[i].o) - light;
            Float8 far = length(to);
            benchmark::DoNotOptimize(transmittance(s.scene(), {broadcast(light), to * (1.f / far)},
                                                   far * 0.999f, kLanes >= 0, broadcast(-1)));
        });
    });
}

void registerPictures(const SubjectName &n) {
    struct Named {
        const char *name;
        Quality quality;
    };
    Quality one = kQualities[(int)QualityName::Play];
    one.grid = 1;
    std::vector<Named> qualities = {{"one sample", one}};
    for (const Quality &q : kQualities)
        if (q.grid == 0) qualities.push_back({q.name, q});
    auto part = [&](const std::string &what, auto &&work) {
        benchmark::RegisterBenchmark(("picture/" + n.name + "/" + what).c_str(),
                                     [=](benchmark::State &state) {
                                         Subject &s = subject(n.name);
                                         for (auto _ : state) work(s);
                                         state.counters["samples/pixel"] = s.samplesPerPixel();
                                     })
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.3);
    };
    part("posing", [](Subject &s) { s.pose(0); });
    for (const Named &q : qualities) part(q.name, [=](Subject &s) { s.trace(q.quality); });
    part("development", [](Subject &s) { s.develop(); });
    part("all of play", [](Subject &s) {
        s.pose(0);
        s.trace(kQualities[(int)QualityName::Play]);
        s.develop();
    });
}

std::vector<Vec3x8> points() {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-9, 9);
    std::vector<Vec3x8> all(64);
    for (Vec3x8 &p : all)
        for (int k = 0; k < 8; ++k) p.x[k] = place(random), p.y[k] = place(random), p.z[k] = place(random);
    return all;
}

void registerTextures() {
    benchmark::RegisterBenchmark("ray/point of noise", [](benchmark::State &state) {
        auto all = points();
        count(state, all.size(), [&](size_t i) { benchmark::DoNotOptimize(noise(all[i])); });
    });
    benchmark::RegisterBenchmark("ray/point of the floor of A", [](benchmark::State &state) {
        auto all = points();
        const Material &m = subject("A").scene().materials[0];
        Vec3x8 d = broadcast(normalize(Vec3{0.3f, -0.5f, 1}));
        count(state, all.size(), [&](size_t i) {
            Int8 cell;
            benchmark::DoNotOptimize(albedo(m, all[i], d, broadcast(0.5f), broadcast(0.01f), cell));
        });
    });
}

} // namespace

int main(int argc, char **argv) {
    registerTextures();
    for (const char *name : {"A", "B", "table", "flake"}) registerRays(name);
    for (const SubjectName &n : subjectNames()) registerPictures(n);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
}
