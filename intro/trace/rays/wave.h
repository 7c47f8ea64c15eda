// Waves: the rays of a stream, which all have the same number of bounces. Their hits are sorted by shape or
// material, so that similar hits are shaded together.
#pragma once

#include "trace/rays/stream.h"
#include "trace/scene/scene.h"

namespace odraz {

// Hits that are shaded together: misses (the sky), hits on one shape, or on balls of one plain material.
struct HitGroup {
    int start, count; // range of SortedHits::rays; start is a multiple of eight
    bool sky, balls;
};

struct SortedHits {
    int groupCount;
    HitGroup groups[kChunk];
    int32_t rays[8 * kChunk + 8]; // indices in the stream; a group's last is repeated up to a multiple of 8
};

// Scratch of sortHits(): numbers of hits on the sky, each shape and each material. All zero between calls.
using HitCounts = int32_t[kMaxShapes + kMaxMaterials + 1];

// Sorts the hits of rays [begin, end) of a stream, at most kChunk. in.shape must be set.
void sortHits(const Scene &scene, const RayStream &in, int begin, int end, HitCounts &counts,
              SortedHits &sorted);

} // namespace odraz
