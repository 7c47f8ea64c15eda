#include "trace/shade/whitted.h"

namespace odraz {

namespace {

// By what a hit is sorted: the sky, a shape, or the material of a ball without texture.
int kindOf(const Scene &scene, int shape) {
    if (shape < 0) return 0;
    const Shape &s = scene.shapes[shape];
    const Material &m = scene.materials[s.material];
    bool merge = s.kind == ShapeKind::Sphere && m.plain();
    return merge ? 1 + kMaxShapes + s.material : 1 + shape;
}

// Shades rays [begin, end) of a stream, which know what they hit.
void shadeChunk(const Context &c, const RayStream &in, RayStream &out, int begin, int end) {
    // Part the stream where what is hit changes; count by kind, and list the kinds in order
    struct Part {
        int begin, count, kind;
    } parts[kChunk];
    int32_t *counts = c.scratch.counts;
    int present[kChunk], kinds = 0, partCount = 0;
    for (int i = begin; i < end;) {
        int shape = in.shape[i], j = i, others;
        do {
            others = laneBits(loadInts(in.shape + j) != shape);
            j += others ? __builtin_ctz((unsigned)others) : 8;
        } while (!others && j < end);
        j = min(j, end);
        int k = kindOf(c.scene, shape);
        parts[partCount++] = {i, j - i, k};
        if (counts[k] == 0) {
            int at = kinds++;
            for (; at > 0 && present[at - 1] > k; --at) present[at] = present[at - 1];
            present[at] = k;
        }
        counts[k] += j - i;
        i = j;
    }
    // Place them kind by kind, each from a multiple of eight on
    int32_t sorted[8 * kChunk + 8];
    int start[kChunk], count[kChunk], place = 0;
    for (int i = 0; i < kinds; ++i) {
        start[i] = place;
        count[i] = counts[present[i]];
        place += (count[i] + 7) & ~7;
        counts[present[i]] = start[i];
    }
    for (int i = 0; i < partCount; ++i) {
        const Part &p = parts[i];
        for (int k = 0; k < p.count; k += 8)
            _mm256_maskstore_epi32(sorted + counts[p.kind] + k, (__m256i)(kLanes < p.count - k),
                                   (__m256i)(kLanes + (p.begin + k)));
        counts[p.kind] += p.count;
    }

    // Shade kind by kind
    Run &run = c.scratch.run;
    for (int i = 0; i < kinds; ++i) {
        counts[present[i]] = 0;
        run.count = count[i];
        run.balls = present[i] > kMaxShapes;
        run.ray = sorted + start[i];
        for (int k = run.count; k & 7; ++k) sorted[start[i] + k] = sorted[start[i] + run.count - 1];
        run.shape = in.shape[run.ray[0]];
        if (present[i] == 0)
            shadeSky(c, in);
        else
            shade(c, in, out);
    }
}

void traceStream(Context &c, int level) {
    RayStream &in = c.scratch.streams[level], &out = c.scratch.streams[level + 1];
    for (int i = 0; level > 0 && i < in.count; i += 8) {
        Hit8 hit = intersect(c.scene, {load(in.o, i), load(in.d, i)}, kLanes < in.count - i);
        store(in.t + i, hit.t);
        store(in.shape + i, hit.shape);
    }
    for (int begin = 0; begin < in.count; begin += kChunk) {
        out.count = 0;
        c.bounces = level;
        shadeChunk(c, in, out, begin, min(begin + kChunk, in.count));
        if (out.count) traceStream(c, level + 1);
    }
}

} // namespace

void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  const Candidates &among, float size, int count, const float *x, const float *y,
                  const uint32_t *index, Sample *samples) {
    Context c = {scene, quality, scratch, samples, 0};
    RayStream &stream = scratch.streams[0];
    for (int first = 0; first < count; first += kChunk) {
        stream.count = min(count - first, kChunk);
        for (int i = 0; i < stream.count; i += 8) {
            Vec3x8 d = normalize(view.direction(load(x + first + i), load(y + first + i)));
            store(stream.o, i, broadcast(view.eye));
            store(stream.d, i, d);
            store(stream.weight, i, broadcast(Rgb{1, 1, 1}));
            store(stream.width + i, Float8{});
            store(stream.spread + i, broadcast(view.spread * size));
            store(stream.sample + i, loadInts((const int32_t *)index + first + i));
            store(stream.path + i, broadcast(1));
            Hit8 hit = intersect(scene, among, view.eye, d, kLanes < stream.count - i);
            store(stream.t + i, hit.t);
            store(stream.shape + i, hit.shape);
        }
        traceStream(c, 0);
    }
}

} // namespace odraz
