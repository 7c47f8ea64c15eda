// In-betweens: a picture between two traced ones in time, made from both.
//
// Rays find the points that pixels show at that moment. Each point is moved with its shape to the moments of
// both pictures, and the colours there are fetched. A colour counts if the picture shows the same shape
// there. If both count, they must agree; if one does, it counts alone, unless the shape is a mirror that
// moves fast or moving glass. All other pixels are traced. After Herzog, Eisemann, Myszkowski and Seidel,
// "Spatio-Temporal Upsampling on the GPU", I3D 2010, and Yang et al., "Image-Based Bidirectional Scene
// Reprojection", SIGGRAPH Asia 2011.
#pragma once

#include "trace/picture/tracer.h"

namespace odraz {

// A picture as traced, before text is drawn, with frame.shapes; and the scene that it shows.
struct Traced {
    Frame frame;
    Scene *scene;
    View view;
};

// Fills frame.quads, which both pictures need for traceBetween().
void markQuads(Frame &frame, Workers &workers);

struct BetweenScratch;
struct Carry;
struct Trust;

// What in-betweens need in addition to a Tracer. It is allocated once.
struct Between {
    BetweenScratch *scratch; // one for every worker
    Carry *carry[2];         // [before or after][shapeCount + 1]; the last entry is the sky
    Trust *trust;            // [shapeCount + 1]; the last entry is the sky
};

extern const size_t kBetweenBytes; // makeBetween() takes at most this from the arena
// Returns false if the arena is full.
bool makeBetween(Between &between, Arena &arena, int workers);

// The traced pictures on either side of a moment; they may be the same.
struct Neighbours {
    const Traced &before, &after;
    float share; // position between before (0) and after (1)
    float gap;   // time between them, in sixtieths of a second
};

// Fills the frame of `now`, whose scene and view belong to its moment. Pixels that must be traced have
// `quality`, but twice its thresholds, squares of up to 8 pixels and at most three samples inside a pixel.
// The result does not depend on the number of workers.
void traceBetween(Between &between, Tracer &tracer, Workers &workers, const Neighbours &n, Traced &now,
                  const Quality &quality);

} // namespace odraz
