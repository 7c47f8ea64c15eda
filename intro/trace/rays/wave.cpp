#include "trace/rays/wave.h"

namespace odraz {

// The key by which a hit is sorted: the sky, a shape, or the material of a ball without texture.
static int kindOf(const Scene &scene, int shape) {
    if (shape < 0) return 0;
    const Shape &s = scene.shapes[shape];
    const Material &m = scene.materials[s.material];
    bool merge = s.isBall() && m.plain();
    return merge ? 1 + kMaxShapes + s.material : 1 + shape;
}

void sortHits(const Scene &scene, const RayStream &in, int begin, int end, HitCounts &counts,
              SortedHits &sorted) {
    // Split the stream into spans of one shape; count the hits of each kind, and list the kinds in order
    struct Span {
        int begin, count, kind;
    } spans[kChunk];
    int present[kChunk], kinds = 0, spanCount = 0;
    for (int i = begin; i < end;) {
        int shape = in.shape[i], j = i, others;
        do {
            others = laneBits(loadInts(in.shape + j) != shape);
            j += others ? __builtin_ctz((unsigned)others) : 8;
        } while (!others && j < end);
        j = min(j, end);
        int k = kindOf(scene, shape);
        spans[spanCount++] = {i, j - i, k};
        if (counts[k] == 0) {
            int at = kinds++;
            for (; at > 0 && present[at - 1] > k; --at) present[at] = present[at - 1];
            present[at] = k;
        }
        counts[k] += j - i;
        i = j;
    }
    // Sort the rays by kind; each kind starts at a multiple of eight
    int next = 0;
    for (int i = 0; i < kinds; ++i) {
        int32_t &count = counts[present[i]];
        sorted.groups[i] = {next, count, present[i] == 0, present[i] > kMaxShapes};
        int start = next;
        next += (count + 7) & ~7;
        count = start;
    }
    for (int i = 0; i < spanCount; ++i) {
        const Span &s = spans[i];
        for (int k = 0; k < s.count; k += 8)
            _mm256_maskstore_epi32(sorted.rays + counts[s.kind] + k, (__m256i)(kLanes < s.count - k),
                                   (__m256i)(kLanes + (s.begin + k)));
        counts[s.kind] += s.count;
    }
    for (int i = 0; i < kinds; ++i) {
        counts[present[i]] = 0;
        const HitGroup &g = sorted.groups[i];
        int32_t *end = sorted.rays + g.start + g.count;
        for (int k = g.count; k & 7; ++k, ++end) *end = end[-1];
    }
    sorted.groupCount = kinds;
}

} // namespace odraz
