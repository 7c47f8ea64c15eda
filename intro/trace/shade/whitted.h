// Whitted ray tracing by waves over streams of rays.
//
// A wave of rays is intersected with the scene. Its hits are sorted by what they hit (wave.h), so that they
// are shaded together, as runs: where they are (arrive.h), what light arrives there (light.h), and how much
// of it the samples get (contribute.h). Reflected and refracted rays (secondary.h) are packed to form the
// next wave. Recursion ends at a depth, and where a ray's share of the picture falls below a cutoff. Source:
// Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
#pragma once

#include "trace/quality.h"
#include "trace/rays/beam.h"
#include "trace/rays/view.h"
#include "trace/rays/wave.h"
#include "trace/shade/run.h"

namespace odraz {

struct TraceScratch {
    RayStream streams[kMaxDepth + 2];
    Run run;
    HitCounts counts;
};

// Traces `count` rays through the points (x, y) of the picture, in pixels from its top left, each into the
// sample of its index. The arrays must be readable up to the next multiple of eight. `size`: the side of the
// square that a sample stands for, in pixels. `among`: candidates of a beam from the eye in which all these
// points lie.
void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  const Candidates &among, float size, int count, const float *x, const float *y,
                  const uint32_t *index, const Samples &samples);

} // namespace odraz
