#include "trace/shade/whitted.h"

#include "trace/shade/arrive.h"
#include "trace/shade/contribute.h"
#include "trace/shade/glowing_balls.h"
#include "trace/shade/light.h"
#include "trace/shade/secondary.h"

namespace odraz {

namespace {

// Shades a run of hits, and appends its reflected and refracted rays to `out`.
void shade(const Shading &c, const RayStream &in, Run &run, RayStream &out) {
    const Material &m = c.scene.materials[c.scene.shapes[run.shape].material];
    arrive(c, in, run);
    if (m.diffuse > 0 || m.specular > 0) illuminate(c, run);
    addSurfaces(c, in, run);
    if (m.ior > 0 || m.reflect > 0) addSecondaryRays(c, in, run, out);
}

// Shades rays [begin, end) of a stream, whose hits are known.
void shadeChunk(const Shading &c, TraceScratch &scratch, const RayStream &in, RayStream &out, int begin,
                int end) {
    SortedHits hits;
    sortHits(c.scene, in, begin, end, scratch.counts, hits);
    Run &run = scratch.run;
    for (int i = 0; i < hits.groupCount; ++i) {
        const HitGroup &g = hits.groups[i];
        run.count = g.count;
        run.balls = g.balls;
        run.ray = hits.rays + g.start;
        run.shape = in.shape[run.ray[0]];
        if (g.sky)
            addSky(c, in, run);
        else
            shade(c, in, run, out);
    }
}

void traceStream(Shading &c, TraceScratch &scratch, int level) {
    RayStream &in = scratch.streams[level], &out = scratch.streams[level + 1];
    for (int i = 0; level > 0 && i < in.count; i += 8) {
        Hit8 hit = intersect(c.scene, {load(in.o, i), load(in.d, i)}, kLanes < in.count - i);
        store(in.t + i, hit.t);
        store(in.shape + i, hit.shape);
    }
    if (level > 0) addGlowingBalls(c, in);
    for (int begin = 0; begin < in.count; begin += kChunk) {
        out.count = 0;
        c.bounces = level;
        shadeChunk(c, scratch, in, out, begin, min(begin + kChunk, in.count));
        if (out.count) traceStream(c, scratch, level + 1);
    }
}

} // namespace

void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  const SamplePoints &points, const Samples &samples) {
    Shading c = {scene, quality, samples, 0};
    RayStream &stream = scratch.streams[0];
    for (int first = 0; first < points.count; first += kChunk) {
        stream.count = min(points.count - first, kChunk);
        for (int i = 0; i < stream.count; i += 8) {
            Vec3x8 d = normalize(view.direction(load(points.x + first + i), load(points.y + first + i)));
            store(stream.o, i, broadcast(view.eye));
            store(stream.d, i, d);
            store(stream.weight, i, broadcast(Rgb{1, 1, 1}));
            store(stream.width + i, Float8{});
            store(stream.spread + i, broadcast(view.spread * points.size));
            store(stream.sample + i, loadInts((const int32_t *)points.index + first + i));
            store(stream.path + i, broadcast(1));
            Hit8 hit = intersect(scene, points.candidates, view.eye, d, kLanes < stream.count - i);
            store(stream.t + i, hit.t);
            store(stream.shape + i, hit.shape);
        }
        traceStream(c, scratch, 0);
    }
}

} // namespace odraz
