// In-betweens: the picture half-way between two traced ones, made from both.
//
// What a pixel shows at that moment is found exactly, by a ray. The place it meets is carried to both moments
// with its shape, and the colours seen there are fetched. They count where the same shape is seen; where both
// do they must agree. All else is traced. After Herzog, Eisemann, Myszkowski and Seidel, "Spatio-Temporal
// Upsampling on the GPU", I3D 2010, and Yang et al., "Image-Based Bidirectional Scene Reprojection", SIGGRAPH
// Asia 2011.
#pragma once

#include "trace/picture/tracer.h"

namespace odraz {

// A picture as it was traced, before letters, with frame.shapes, and the scene that it shows.
struct Traced {
    Frame frame;
    Scene *scene;
    View view;
};

struct BetweenScratch;
struct Carry;

// What it takes beyond a Tracer, taken once.
struct Between {
    BetweenScratch *scratch; // of every worker
    Carry *carry[2];         // of every shape to either picture, and behind the last one of the sky
    int workers;
};

extern const size_t kBetweenBytes; // for all of it
// False where the arena is full.
bool makeBetween(Between &between, Arena &arena, int workers);

// Fills the frame of `now`, whose scene and view are those of its moment, from the pictures of as long before
// and after it. What must be traced has the quality given. It does not depend on the number of workers.
void traceBetween(Between &between, Tracer &tracer, Workers &workers, const Traced &before,
                  const Traced &after, const Quality &quality, Traced &now);

// Pixels that were traced since it was last asked.
int64_t tracedAnew(Between &between);

} // namespace odraz
