// Clips facets to the faces of a hemicube, in the frame of the hemicube: z is the surface's normal.
//
// A face has four borders: x + w, w - x, y + w (just y on the four half faces) and w - y must not be
// negative.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct Corner {
    float x, y, w; // on a face: |x| <= w, y <= w, -w or 0 <= y
    float s, t;    // place on the chart, in patches
};

// The borders of the five faces that a point lies beyond: four bits a face. The top face has the lowest bits,
// then come the faces that look to +x, +y, -x and -y.
uint32_t outsideFaces(const Vec3 &p);

// Cuts a convex polygon of 3 or 4 corners at the borders whose bits are set in `crossed`, and changes
// `count`. Every border adds one corner at most; the buffers have room for that.
const Corner *clipToFace(const Corner *polygon, int &count, bool top, uint32_t crossed,
                         Corner (&buffers)[2][8]);

} // namespace odraz
