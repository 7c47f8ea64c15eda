// Waves: the rays of a stream, which have all made the same number of bounces. Their hits are sorted by what
// they hit, so that hits on the same shape or material are shaded together.
#pragma once

#include "trace/rays/stream.h"
#include "trace/scene/scene.h"

namespace odraz {

// Hits that are shaded together: those that miss everything (the sky), those on one shape, or those on balls
// of one plain material.
struct HitGroup {
    int start, count; // in SortedHits::place; start is a multiple of eight
    bool sky, balls;
};

struct SortedHits {
    int groupCount;
    HitGroup groups[kChunk];
    int32_t place[8 * kChunk + 8]; // in the stream; a group's last one is repeated up to a multiple of eight
};

// Scratch of sortHits(): how many rays hit the sky, each shape and each material. All zero between calls.
using HitCounts = int32_t[kMaxShapes + kMaxMaterials + 1];

// Sorts the hits of rays [begin, end) of a stream, at most kChunk. in.shape is set.
void sortHits(const Scene &scene, const RayStream &in, int begin, int end, HitCounts &counts,
              SortedHits &sorted);

} // namespace odraz
