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

// Points of the picture. The arrays must be readable up to the next multiple of eight.
struct SamplePoints {
    const Candidates &among; // of a beam from the eye in which all points lie
    float size;              // side of the square that a sample stands for, in pixels
    int count;
    const float *x, *y;    // in pixels from the picture's top left
    const uint32_t *index; // of each point's sample
};

// Traces a ray through each point, into its sample.
void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  const SamplePoints &points, const Samples &samples);

} // namespace odraz
