// Waves: the rays of a stream that make the same bounce; their hits are sorted, so that like is shaded with
// like.
#pragma once

#include "trace/rays/stream.h"
#include "trace/scene/scene.h"

namespace odraz {

// Hits that go together: of nothing (the sky), of one shape, or of balls of one plain material.
struct HitGroup {
    int start, count; // in SortedHits::place; start is a multiple of eight
    bool sky, balls;
};

struct SortedHits {
    int groupCount;
    HitGroup groups[kChunk];
    int32_t place[8 * kChunk + 8]; // in the stream; a group's last one is repeated up to a multiple of eight
};

// How many rays hit what, while they are sorted; all zero in between.
using HitCounts = int32_t[kMaxShapes + kMaxMaterials + 1];

// Sorts rays [begin, end) of a stream, at most kChunk, which know what they hit.
void sortHits(const Scene &scene, const RayStream &in, int begin, int end, HitCounts &counts,
              SortedHits &sorted);

} // namespace odraz
