// bench_hits: closest hits a second of the film's tracer and of Embree 3, for the same rays on one thread.
#include "tools/common/clock.h"
#include "tools/common/statistics.h"
#include "tools/measure/bench/subject.h"
#include "trace/rays/beam.h"

#include <cstdio>
#include <embree3/rtcore.h>
#include <numeric>

namespace odraz::measure {

constexpr int kWidth = 1280, kHeight = 720, kRounds = 7;
constexpr int kBlock = 16, kPackets = kBlock * kBlock / 8; // pixels across, and packets, that share a beam
constexpr float kPlane = 1e4f;                             // Embree's planes end at this distance
static const Int8 kAll = kLanes >= 0;

using Rays = std::vector<Ray8>;

// The rays through the middles of all pixels, block by block, in packets of four by two.
static Rays firstRays(const View &view) {
    Rays rays;
    for (int y = 0; y < kHeight; y += kBlock)
        for (int x = 0; x < kWidth; x += kBlock)
            for (int i = 0; i < kPackets; ++i) {
                Int8 across = (kLanes & 3) + (x + i % 4 * 4), down = (kLanes >> 2) + (y + i / 4 * 2);
                Vec3x8 to = view.direction(toFloat(across) + 0.5f, toFloat(down) + 0.5f);
                rays.push_back({broadcast(view.eye), normalize(to)});
            }
    return rays;
}

// The mirrored rays of those packets whose rays all hit something.
static Rays reflections(const Scene &scene, const Rays &rays) {
    Rays mirrored;
    for (const Ray8 &ray : rays) {
        Hit8 hit = intersect(scene, ray, kAll);
        if (any(hit.shape < 0)) continue;
        Ray8 to = {};
        for (int k = 0; k < 8; ++k) {
            const Shape &shape = scene.shapes[hit.shape[k]];
            Surface8 at = surfaceAt(shape, ray, hit.t);
            Int8 here = hit.shape == hit.shape[k];
            to.o = select(here, offsetOrigin(shape, at, broadcast(1.f)), to.o);
            to.d = select(here, ray.d - at.n * (dot(ray.d, at.n) * 2.f), to.d);
        }
        mirrored.push_back(to);
    }
    return mirrored;
}

// The beam of a block of first rays. The film's share one, too, and try only the shapes that it may touch.
static Beam beamOf(const Ray8 *block) {
    auto at = [](Vec3x8 v, int k) { return Vec3{v.x[k], v.y[k], v.z[k]}; };
    return beamThrough(at(block->o, 0), {at(block[0].d, 0), at(block[3].d, 3), at(block[kPackets - 1].d, 7),
                                         at(block[kPackets - 4].d, 4)});
}

template <class Item>
static Item *buffer(RTCGeometry of, RTCBufferType type, RTCFormat format, size_t count) {
    return (Item *)rtcSetNewGeometryBuffer(of, type, 0, format, sizeof(Item), count);
}

// The balls of a scene as Embree's spheres; its planes, which face up, as quads of two triangles.
static RTCScene embreeScene(RTCDevice device, const Scene &scene) {
    size_t planes = (size_t)scene.unboundedCount, balls = (size_t)scene.shapeCount - planes;
    RTCGeometry spheres = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT),
                quads = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
    auto *index = buffer<unsigned[4]>(quads, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT4, planes)[0];
    std::iota(index, index + 4 * planes, 0u);
    auto *ball = buffer<float[4]>(spheres, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, balls)[0];
    auto *corner = buffer<Vec3>(quads, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 4 * planes);
    for (const Shape *s = scene.shapes; s < scene.shapes + scene.shapeCount; ++s) {
        common::need(s->isBall() || s->kind == ShapeKind::Plane, "Embree gets only balls and planes");
        if (s->isBall())
            for (float number : {s->centre.x, s->centre.y, s->centre.z, s->half.x}) *ball++ = number;
        else
            for (auto [x, z] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
                *corner++ = s->centre + Vec3{(float)x, 0, (float)z} * kPlane;
    }
    RTCScene made = rtcNewScene(device);
    for (RTCGeometry geometry : {spheres, quads})
        rtcCommitGeometry(geometry), rtcAttachGeometry(made, geometry);
    rtcCommitScene(made);
    return made;
}

static Float8 embreeDistance(RTCScene scene, const Ray8 &ray, bool coherent) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    RTCRayHit8 at;
    store(at.ray.org_x, ray.o.x), store(at.ray.org_y, ray.o.y), store(at.ray.org_z, ray.o.z);
    store(at.ray.dir_x, ray.d.x), store(at.ray.dir_y, ray.d.y), store(at.ray.dir_z, ray.d.z);
    store(at.ray.tnear, Float8{}), store(at.ray.tfar, broadcast(kInfinity)), store(at.ray.time, Float8{});
    for (unsigned *from : {at.ray.mask, at.hit.geomID, at.hit.instID[0]}) store((int *)from, broadcast(-1));
    rtcIntersect8((const int *)&kAll, scene, &context, &at);
    return load(at.ray.tfar);
}

// Measures both tracers in turn. Prints their speed, and the number of rays on which they disagree.
static void compare(const Scene &scene, RTCScene theirs, const Rays &rays, bool first) {
    std::vector<Float8> found[2] = {std::vector<Float8>(rays.size()), std::vector<Float8>(rays.size())};
    std::vector<double> rates[2];
    Candidates candidates;
    auto ours = [&](size_t i) {
        if (!first) return intersect(scene, rays[i], kAll).t;
        if (i % kPackets == 0) findCandidates(scene, beamOf(&rays[i]), candidates);
        auto [x, y, z] = rays[i].o;
        return intersect(scene, candidates, {x[0], y[0], z[0]}, rays[i].d, kAll).t;
    };
    double millions = 8e-6 * (double)rays.size();
    for (int turn = 0; turn < 2 * kRounds; ++turn) {
        double began = common::processorSeconds();
        for (size_t i = 0; i < rays.size(); ++i)
            found[turn % 2][i] = turn % 2 ? embreeDistance(theirs, rays[i], first) : ours(i);
        rates[turn % 2].push_back(millions / (common::processorSeconds() - began));
    }
    int differ = 0;
    for (size_t i = 0; i < rays.size(); ++i)
        differ += __builtin_popcount((unsigned)laneBits(abs(found[0][i] / found[1][i] - 1) > 1e-3f));
    double rate = common::median(rates[0]), other = common::median(rates[1]);
    std::printf("%s,%.0f,%.0f,%.1f,%.2f,%d\n", first ? "first rays" : "reflections", rate, other,
                rate / other, millions, differ);
}

static int run(common::CommandLine &line) {
    line.about("Compares closest hits with Embree 3, in millions a second. Prints a CSV.");
    line.parse();
    std::puts("scene,rays,odraz,embree,times,millions,differ");
    RTCDevice device = rtcNewDevice("threads=1");
    Workers workers = serialWorkers();
    MeasuredFilm film({kWidth, kHeight}, workers, false);
    const Scene &scene = *film.intro->film.scene;
    for (const char *name : {"A", "flake", "B"}) {
        Rays rays = firstRays(poseSubject(findSubject(name), {kWidth, kHeight}, film.intro->film));
        RTCScene theirs = embreeScene(device, scene);
        for (bool first : {true, false}) {
            std::printf("%s,", name);
            compare(scene, theirs, first ? rays : reflections(scene, rays), first);
        }
    }
    return 0;
}

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("bench_hits", argc, argv, odraz::measure::run); }
