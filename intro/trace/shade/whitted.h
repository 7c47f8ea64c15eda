// Whitted ray tracing by waves over streams of rays.
//
// A wave of rays is intersected with the scene. Its hits are sorted by shape or material (wave.h) into runs,
// which are shaded together: surface points (arrive.h), the light that arrives there (light.h), and what that
// adds to the samples (contribute.h). Reflected and refracted rays (secondary.h) form the next wave.
// Recursion ends at a greatest depth, and where a ray's share of the picture falls below a cutoff. Source:
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
    const Candidates &candidates; // shapes in a beam from the eye through all points
    float size;                   // side of the square that a sample covers, in pixels
    int count;
    const float *x, *y;    // in pixels from the picture's top left
    const uint32_t *index; // index of each point's sample
};

// Traces a ray through each point, and writes what it sees to the point's sample.
void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  const SamplePoints &points, const Samples &samples);

} // namespace odraz
