// What rays add to their samples.
#pragma once

#include "trace/shade/run.h"

namespace odraz {

// What a run shows, lit as it is, and what marks it leaves.
void addShown(const Context &c, const RayStream &in, const Run &run);

// Light and marks for the samples of up to eight rays of a stream.
void addRest(const Context &c, const RayStream &in, const int32_t *ray, int count, const Rgb8 &light,
             Int8 marks);

// The sky, for a run that meets nothing.
void addSky(const Context &c, const RayStream &in, const Run &run);

} // namespace odraz
