// Adds the light of rays, and their marks, to samples.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// Adds the light that a run's hits send along their rays, and their marks.
void addSurfaces(const Shading &c, const RayStream &in, const Run &run);

// Adds light and marks to the samples of up to eight rays of a stream.
void addLight(const Shading &c, const RayStream &in, const int32_t *ray, int count, const Rgb8 &light,
              Int8 marks);

// Adds the sky's light, for a run of rays that hit nothing.
void addSky(const Shading &c, const RayStream &in, const Run &run);

} // namespace odraz
